#include "capture/strengths.h"

#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

TEST(Strengths, AreWhatAWavedSheetAgreesOn) {
  Rig rig = table_rig({});
  LightStack stack = photograph(waved_sheet(24.0), rig);
  const auto truth = stack.lights;
  for (Light& light : stack.lights) light.strength.setOnes();
  balance_strengths(stack);
  double mean = 0.0;
  for (const Light& light : truth) mean += light.strength[0] / double(truth.size());
  // The lights differ by 20 %; slopes up to 20 degrees settle most, not all, of that.
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_NEAR(stack.lights[k].strength[0], truth[k].strength[0] / mean, 0.03);
  }
}

TEST(Strengths, AreLeftAloneWhereTheyAreRight) {
  LightStack stack = photograph(waved_sheet(24.0), table_rig({}));
  const auto truth = stack.lights;
  balance_strengths(stack);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    // 14 000 pixels with noise of 0.3 %: 3e-5; what is left is the 1e-6 of the last round, summed.
    EXPECT_NEAR(stack.lights[k].strength[0] / truth[k].strength[0], 1.0, 2e-3);
  }
}

TEST(Strengths, KnowTheColoursOfLamps) {
  Rig rig = table_rig({});
  for (std::size_t k = 0; k < 6; ++k) {
    Eigen::Vector3d& strength = rig.lights[k].strength;
    strength = strength.cwiseProduct(k % 2 == 0 ? Eigen::Vector3d(1.3, 0.8, 0.5)
                                                : Eigen::Vector3d(0.7, 0.9, 1.2));
  }
  LightStack stack = photograph(waved_sheet(24.0), rig);
  const auto truth = stack.lights;
  for (Light& light : stack.lights) light.strength.setOnes();
  EXPECT_TRUE(balance_strengths(stack));
  const auto gauge = [&](std::size_t k, int c) {
    return stack.lights[k].strength[c] / truth[k].strength[c];
  };
  for (std::size_t k = 1; k < 6; ++k) {
    // Two lamps, each known to 0.03 as above; their colours by the noise of 14 000 pixels alone.
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(gauge(k, c) / gauge(0, c), gauge(k, 0) / gauge(0, 0), 1e-3);
      EXPECT_NEAR(gauge(k, c) / gauge(0, c), 1.0, 0.06);
    }
  }
}

TEST(UnknownStrengths, AreOffByAFifthEach) {
  const auto lights = six_lights();
  const auto modes = unknown_strengths(lights);
  ASSERT_EQ(modes.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t other = 0; other < 6; ++other) {
      EXPECT_DOUBLE_EQ(modes[k][other].norm(), k == other ? 0.2 * lights[k].strength.mean() : 0.0);
    }
  }
}

}  // namespace
}  // namespace hada
