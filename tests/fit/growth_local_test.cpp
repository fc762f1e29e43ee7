#include "fit/growth_local.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

GrowthFrame lobed() {
  return {{-3.0, 2.0}, {{2.0, 0.04, -0.03}, {3.0, 0.01, 0.02, 5.0, 15.0}}};
}

TEST(GrowthLocal, IsTheRadiusOfTheFrameWithItsDerivatives) {
  const GrowthFrame frame = lobed();
  const Eigen::VectorXd state = packed(frame);
  // Differences over 2e-6 of numbers near 10: good to 1e-9 by rounding, and by their cubes.
  constexpr double step = 1e-6;
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(8.0, 1.0), Eigen::Vector2d(-9.0, 7.0)}) {
    const GrowthLocal local = growth_at(frame, place);
    EXPECT_NEAR(local.rho, frame.rho_of(place), 1e-12);
    for (Eigen::Index k = 0; k < state.size(); ++k) {
      Eigen::VectorXd ahead = state, behind = state;
      ahead[k] += step, behind[k] -= step;
      const double slope =
          (unpacked(frame, ahead).rho_of(place) - unpacked(frame, behind).rho_of(place)) /
          (2.0 * step);
      EXPECT_NEAR(local.slopes[k], slope, 1e-7) << k;
    }
  }
}

TEST(GrowthLocal, KnowsNothingOfAPithBeforehandAndSomethingOfLobes) {
  const Eigen::VectorXd prior = growth_prior(lobed());
  EXPECT_LT(prior.head<2>().maxCoeff(), 1e-3);
  EXPECT_GT(prior.tail(4).minCoeff(), 1.0);
  EXPECT_GT(prior[4], prior[2]);  // high orders are smaller
}

}  // namespace
}  // namespace hada
