#include "studio/folder.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  Folder() {
    fs::create_directories(root_ / "sheet");
    put(root_ / "sheet" / "surface.json", "{}");
    put(root_ / ".hidden", "secret");
    put(outside_.path() / "secret.txt", "secret");
    fs::create_symlink(outside_.path() / "secret.txt", root_ / "link");
    fs::create_directory_symlink(outside_.path(), root_ / "way");
    fs::create_symlink(root_ / "sheet" / "surface.json", root_ / "inner");
    // A neighbour whose path begins as that of the folder does.
    fs::create_directories(root_.string() + "-other");
    fs::create_directory_symlink(root_.string() + "-other", root_ / "neighbour");
  }
  TemporaryFolder within_, outside_;
  const fs::path root_ = within_.path() / "served";
};

TEST_F(Folder, GivesWhatIsInIt) {
  EXPECT_EQ(place_within(root_, ""), fs::canonical(root_));
  EXPECT_EQ(place_within(root_, "sheet/surface.json"),
            fs::canonical(root_) / "sheet" / "surface.json");
  EXPECT_EQ(place_within(root_, "inner"), place_within(root_, "sheet/surface.json"));
  EXPECT_EQ(text_within(root_, "sheet/surface.json"), "{}");
}

TEST_F(Folder, GivesNothingElse) {
  for (const std::string name : {"..", "../secret.txt", "sheet/../../served", "/etc/passwd",
                                 ".hidden", "sheet/./surface.json", "link", "way", "way/secret.txt",
                                 "neighbour", "missing", "sheet/surface.json/more"}) {
    EXPECT_THROW(place_within(root_, name), Error) << name;
  }
  EXPECT_THROW(place_within(root_, std::string("sheet\0", 6)), Error);
  EXPECT_THROW(place_within(root_, std::string(2000, 'a')), Error);
  EXPECT_THROW(place_within(root_ / "missing", ""), Error);
}

TEST_F(Folder, GivesNoTextOfAFolder) {
  EXPECT_THROW(text_within(root_, "sheet"), Error);
}

TEST_F(Folder, IsNotNamedToThePage) {
  EXPECT_EQ(without_folder("/served", "/served/a.png: broken, see /served"), "a.png: broken, see ");
  EXPECT_EQ(without_folder("/served", "all is well"), "all is well");
}

}  // namespace
}  // namespace hada
