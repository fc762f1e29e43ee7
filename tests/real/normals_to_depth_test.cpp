#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"

namespace hada {
namespace {

TEST(NormalsToDepth, IsNoWorseThanTheBetterOfTwoPublishedMethods) {
  if (!std::filesystem::exists(data_folder() / "normals_to_depth")) {
    GTEST_SKIP() << "the objects are not in " << data_folder();
  }
  struct Published {
    const char* object;
    double bilateral_mm;  // Cao et al., ECCV 2022, by their program
    double plain_mm;      // least squares on logarithmic depth
  };
  for (const Published& p :
       {Published{"bear", 0.334, 0.138}, Published{"cat", 0.074, 2.124},
        Published{"goblet", 9.018, 8.922}, Published{"reading", 0.257, 2.837}}) {
    const DepthScore found = normals_to_depth(data_folder(), p.object);
    EXPECT_LE(found.error_mm, std::min(p.bilateral_mm, p.plain_mm)) << p.object;
    EXPECT_FALSE(found.reason.empty());
  }
}

// Of the inside of the goblet nothing tells how far it lies behind the rim, but both parts keep
// their shape: least squares alone is 7.69 mm off, jumps alone 9.63 mm.
TEST(NormalsToDepth, PutsWhatIsCutOffWhereLeastSquaresHasIt) {
  if (!std::filesystem::exists(data_folder() / "normals_to_depth")) {
    GTEST_SKIP() << "the objects are not in " << data_folder();
  }
  const DepthScore found = normals_to_depth(data_folder(), "goblet");
  EXPECT_TRUE(found.may_jump);
  EXPECT_LT(found.error_mm, 7.4);
  EXPECT_NE(found.reason.find("cut 35 %"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace hada
