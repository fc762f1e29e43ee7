#include "io/whole_file.h"

#include <string>

#include <gtest/gtest.h>

#include "io/image_file.h"

namespace hada {
namespace {

using namespace std::string_literals;

// The frame of a JPEG: a segment with a thumbnail inside, whose end marker must not count, then a
// scan with a stuffed byte (0xff00) and a restart marker (0xffd0).
std::string jpeg() {
  const std::string thumbnail = "\xff\xd8\xff\xda\x00\x02zz\xff\xd9"s;
  const std::string segment = "\xff\xe1"s + '\0' + char(2 + thumbnail.size()) + thumbnail;
  return "\xff\xd8"s + segment + "\xff\xda\x00\x04yz"s + "data\xff\x00more\xff\xd0rest"s +
         "\xff\xd9"s;
}

TEST(WholeFile, SeesThatAJpegReachesItsOwnEnd) {
  const std::string whole = jpeg();
  EXPECT_TRUE(is_whole(whole));
  EXPECT_TRUE(is_whole(whole + "trailing bytes"));
  for (std::size_t size = 3; size < whole.size(); ++size) {
    EXPECT_FALSE(is_whole(whole.substr(0, size))) << size;
  }
}

TEST(WholeFile, SeesEveryCutAndEveryChangedByteOfAPng) {
  const auto bytes = encode_png(Image(5, 7, 3));
  const std::string whole(bytes.begin(), bytes.end());
  EXPECT_TRUE(is_whole(whole));
  for (std::size_t i = 8; i < whole.size(); ++i) {
    EXPECT_FALSE(is_whole(whole.substr(0, i))) << i;
    std::string changed = whole;
    changed[i] = char(changed[i] ^ 0x10);
    EXPECT_FALSE(is_whole(changed)) << i;
  }
}

TEST(WholeFile, SeesThatATiffLacksItsDirectory) {
  const std::string little = "II\x2a\0\x10\0\0\0"s + "12345678"s + "\x01\0"s;
  const std::string big = "MM\0\x2a\0\0\0\x10"s + "12345678"s + "\0\x01"s;
  for (const std::string& whole : {little, big}) {
    EXPECT_TRUE(is_whole(whole));
    for (std::size_t size = 4; size < whole.size(); ++size) {
      EXPECT_FALSE(is_whole(whole.substr(0, size))) << size;
    }
  }
  EXPECT_FALSE(is_whole("II\x2a\0\xff\xff\xff\xff and no more"s));
}

TEST(WholeFile, LeavesOtherFormatsToOthers) {
  EXPECT_TRUE(is_whole(""));
  EXPECT_TRUE(is_whole("II*"));
}

}  // namespace
}  // namespace hada
