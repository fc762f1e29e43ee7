#include "io/capture_folder.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CaptureFolder sorted(const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  for (const auto& name : names) put(folder / name, "");
  return sorted_folder(folder.path());
}

TEST(NaturalLess, CountsRunsOfDigitsAsNumbers) {
  EXPECT_TRUE(natural_less("a2", "a10"));
  EXPECT_TRUE(natural_less("a9b", "a10"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_TRUE(natural_less("x.2.tga", "x.11.tga"));
  EXPECT_TRUE(natural_less("a99999999999999999998", "a99999999999999999999"));
  EXPECT_FALSE(natural_less("a10", "a2"));
  EXPECT_FALSE(natural_less("a1", "a1"));
}

RC_GTEST_PROP(NaturalLess, IsAStrictOrder, ()) {
  const auto letters = rc::gen::container<std::string>(rc::gen::element('0', '1', '2', 'a', 'b'));
  const std::string a = *letters;
  const std::string b = *letters;
  const std::string c = *letters;
  RC_ASSERT(!natural_less(a, a));
  RC_ASSERT(a == b || natural_less(a, b) != natural_less(b, a));
  RC_ASSERT(!(natural_less(a, b) && natural_less(b, c)) || natural_less(a, c));
}

TEST(SortedFolder, FindsPicturesInNaturalOrderAndNamesTheRest) {
  const auto folder =
      sorted({"cat.10.tga", "cat.2.TGA", "cat.mask.tga", "notes.txt", "dark.png", "cat.albedo.tga",
              "ambient.exr", ".hidden", "capture.json", "below/deeper.png"});
  EXPECT_THAT(folder.pictures, ElementsAre("cat.2.TGA", "cat.10.tga"));
  EXPECT_EQ(folder.auxiliary.at("mask"), "cat.mask.tga");
  EXPECT_EQ(folder.auxiliary.at("dark"), "dark.png");
  EXPECT_EQ(folder.auxiliary.at("ambient"), "ambient.exr");
  EXPECT_FALSE(folder.auxiliary.contains("flat"));
  EXPECT_THAT(folder.left_out,
              ElementsAre("below (not a file)", "cat.albedo.tga (not a photograph)",
                          "notes.txt (not an image)"));
}

TEST(SortedFolder, TakesASeriesForPicturesWhateverItsName) {
  EXPECT_THAT(sorted({"flat_1.png", "flat_2.png", "flat_3.png"}).pictures,
              ElementsAre("flat_1.png", "flat_2.png", "flat_3.png"));
  EXPECT_THAT(sorted({"darkoak1.png", "darkoak2.png"}).pictures,
              ElementsAre("darkoak1.png", "darkoak2.png"));
  const auto damask = sorted({"damask1.png", "damask2.png", "damask3.png", "mask.png"});
  EXPECT_THAT(damask.pictures, ElementsAre("damask1.png", "damask2.png", "damask3.png"));
  EXPECT_EQ(damask.auxiliary.at("mask"), "mask.png");
}

TEST(SortedFolder, FindsAMaskInTheMiddleOfAWord) {
  const auto folder = sorted({"a1.png", "a2.png", "mymask.png"});
  EXPECT_EQ(folder.auxiliary.at("mask"), "mymask.png");
  EXPECT_EQ(folder.pictures.size(), 2u);
}

TEST(SortedFolder, NamesASecondMask) {
  const auto folder = sorted({"a1.png", "mask.png", "mask_old.png"});
  EXPECT_EQ(folder.auxiliary.at("mask"), "mask.png");
  EXPECT_THAT(folder.left_out, ElementsAre("mask_old.png (another mask)"));
}

TEST(SortedFolder, RefusesWhatIsNoFolder) {
  const TemporaryFolder folder;
  put(folder / "file", "");
  EXPECT_THAT(error_of([&] { sorted_folder(folder / "file"); }), HasSubstr("is not a folder"));
  EXPECT_THAT(error_of([&] { sorted_folder(folder / "none"); }), HasSubstr("no such folder"));
}

}  // namespace
}  // namespace hada
