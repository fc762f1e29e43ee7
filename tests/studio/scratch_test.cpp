#include "studio/scratch.h"

#include <fstream>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Scratch, IsGoneWithAllThatIsInIt) {
  std::filesystem::path path;
  {
    const Scratch scratch;
    path = scratch.path();
    std::filesystem::create_directories(path / "maps");
    std::ofstream(path / "maps" / "height.exr") << "x";
    EXPECT_TRUE(std::filesystem::exists(path / "maps" / "height.exr"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, IsAnotherEachTime) {
  const Scratch one, other;
  EXPECT_NE(one.path(), other.path());
}

TEST(Download, HasAPlainName) {
  const auto answer = download("a \"b\"\r\n/../c_1.fold", "bytes");
  ASSERT_EQ(answer.headers.size(), 1u);
  EXPECT_EQ(answer.headers[0].second, "attachment; filename=\"a__b____.._c_1.fold\"");
  EXPECT_EQ(answer.body, "bytes");
}

}  // namespace
}  // namespace hada
