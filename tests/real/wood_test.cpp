#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"
#include "bench/recorded_wood.h"
#include "bench/wood_study.h"

namespace hada {
namespace {

TEST(RenderedWoodBlock, IsReadAsItWasPainted) {
  const auto folder = data_folder() / "rendered" / "wood_block";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no rendered blocks in " << folder;
  for (const char* name : {"softwood_a", "ringporous_b"}) {
    const auto score = score_block(folder, name);
    EXPECT_LT(score.pith_mm, 0.05) << name;   // 0.3 mm inside and 1.5 mm outside is asked for
    EXPECT_LT(score.radii_mm, 0.01) << name;  // a seventh of a pixel; 0.05 is asked for
    EXPECT_GE(score.recall, 0.98) << name;
    EXPECT_GE(score.precision, 0.95) << name;
    EXPECT_LT(score.spiral_deg, 0.3) << name;
  }
}

TEST(DiscF02b, AgreesWithAnotherProgram) {
  const auto folder = data_folder() / "wood" / "disc";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no disc in " << folder;
  const auto score = score_disc(folder);
  EXPECT_LT(score.pith_share, 0.01);
  EXPECT_EQ(score.followed, 20);  // of 21; one it drew between two others, without an edge
  EXPECT_EQ(score.followed_found, score.followed);
  EXPECT_LT(score.radius_px, 0.5);
}

TEST(XrayProfiles, HaveAsManyRingsAsYears) {
  const auto folder = data_folder() / "wood" / "xray_profiles";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no profiles in " << folder;
  const auto score = score_profiles(folder);
  EXPECT_GE(18 * score.right, 17 * score.dated);
}

}  // namespace
}  // namespace hada
