#include "fit/ring_threads.h"

#include <gtest/gtest.h>

#include "tests/fit/dark_lines.h"

namespace hada {
namespace {

TEST(RingThreads, RunAlongRingsWhicheverTheseAre) {
  const GrowthSolid solid = far_stem();
  const Extent extent{200, 200, 1.0, Unit::px};
  for (const Cut& cut : {Cut(), cut_along({-100, 0, 0}, {0, -1, 0}, {0, 0, 1})}) {
    const auto threads = ring_threads(dark_lines(solid, solid.radii, cut, extent), 3, 22.0);
    ASSERT_GT(threads.size(), 30u);  // of 81 middles
    double squares = 0.0;
    for (const RingThread& thread : threads) {
      EXPECT_EQ(thread.face, 3u);
      const double along = local_of(solid, thread.to).rho - local_of(solid, thread.from).rho;
      squares += along * along / double(threads.size());
    }
    // A thread is 22 px long; 0.1 rad of a window of 9 px that sees a line of 2.5 px and noise of
    // a fifteenth of it would be 2.2 px, a picture without lines 11.
    EXPECT_LT(std::sqrt(squares), 1.5);
  }
}

TEST(RingThreads, AreNotSeenInNoise) {
  const GrowthSolid solid = far_stem();
  const auto threads =
      ring_threads(dark_lines(solid, {}, Cut(), {200, 200, 1.0, Unit::px}), 0, 22.0);
  EXPECT_LT(threads.size(), 40u);  // of 81: chance makes some directions coherent
}

}  // namespace
}  // namespace hada
