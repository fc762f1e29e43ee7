#include "mechanics/knit_newton.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "mechanics/knit_pull.h"

namespace hada {
namespace {

TEST(KnitNewton, StepsWhereTheForcesChangeByTheLoad) {
  KnitNet net;
  net.courses = 9, net.wales = 11;
  net.stiffness = stiffness_of_courses(9, 10.0);
  const auto [held, places] = pulled(net, KnitPull::wale, KnitClamp::uniform, 1.4);
  const KnitSprings springs = springs_of(held, places);
  const KnitFrames frames{2, {places.size(), Eigen::Matrix3d(Eigen::Matrix3d::Identity())}};
  Places load;
  for (int i = 0; i < held.points(); ++i) load.emplace_back(gaussian(5, i), gaussian(6, i), 0.0);
  KnitNewton newton(held, 2);
  for (const double drag : {0.0, 0.3}) {
    const Places step = newton.step(held, springs, frames, load, 1e-10, drag);
    const Places change = force_changes(held, springs, step);
    for (int i = 0; i < held.points(); ++i) {
      const auto p = std::size_t(i);
      if (held.is_pinned(i)) {
        EXPECT_EQ(step[p].norm(), 0.0);
      } else {
        // 1e-10 of the load's norm, sqrt(2 * 99) = 14.
        EXPECT_LT((change[p] - drag * step[p] - load[p]).norm(), 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace hada
