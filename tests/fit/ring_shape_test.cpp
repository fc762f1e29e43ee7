#include "fit/ring_shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
const GrowthFrame truth{{3.0, -2.0}, {{2.0, 0.05, -0.02}, {3.0, 0.01, 0.01}}};

/// 120 points on each of six rings, off by `noise`.
std::vector<RingPoint> points_of(const GrowthFrame& frame, double noise, Seed seed) {
  std::vector<RingPoint> points;
  for (int ring = 0; ring < 6; ++ring) {
    for (int k = 0; k < 120; ++k) {
      const double rho = 8.0 * (ring + 1) + noise * gaussian(seed, ring, k);
      points.push_back({frame.place_of(rho, 2.0 * pi * k / 120), ring});
    }
  }
  return points;
}

RingShape fitted(const std::vector<RingPoint>& points) {
  return fitted_shape(points, 6, {{0.0, 0.0}, {{2.0}, {3.0}}});
}

TEST(RingShape, FindsPithLobesAndRadii) {
  const auto shape = fitted(points_of(truth, 0.0, 1));
  // The prior of the lobes pulls by the variance of the scatter, which here is its least, 1e-9.
  EXPECT_NEAR((shape.frame.pith - truth.pith).norm(), 0.0, 1e-6);
  EXPECT_NEAR(shape.frame.lobes[0].cosine, 0.05, 1e-6);
  EXPECT_NEAR(shape.frame.lobes[1].sine, 0.01, 1e-6);
  for (int ring = 0; ring < 6; ++ring)
    EXPECT_NEAR(shape.radii[std::size_t(ring)], 8.0 * (ring + 1), 1e-5);
}

TEST(RingShape, KnowsHowSureItIs) {
  double squares = 0.0;
  constexpr int seeds = 60;
  for (Seed seed = 0; seed < seeds; ++seed) {
    const auto shape = fitted(points_of(truth, 0.2, seed));
    squares += std::pow((shape.frame.pith.x() - truth.pith.x()) / shape.pith_sigma.x(), 2) / seeds;
  }
  // 1 if sigma is right, known to sqrt(2 / 60) = 0.18 from 60 seeds: three of those.
  EXPECT_NEAR(squares, 1.0, 0.55);
}

TEST(RingShape, DoesNotMindPointsOfAnotherRing) {
  auto points = points_of(truth, 0.05, 2);
  for (std::size_t i = 0; i < points.size(); i += 10) points[i].place *= 1.15;
  const auto shape = fitted(points);
  // 648 good points scatter by 0.05: the pith is known to 0.05 sqrt(2 / 648) = 0.003; times 5, and
  // as much again for what the loss still hears of the others.
  EXPECT_LT((shape.frame.pith - truth.pith).norm(), 0.03);
}

TEST(RingShape, GainsFromLobesThatAreThereAlone) {
  const auto points = points_of(truth, 0.05, 3);
  const auto plain = fitted_shape(points, 6, {{0.0, 0.0}, {{2.0}}});
  const auto right = fitted_shape(points, 6, {{0.0, 0.0}, {{2.0}, {3.0}}});
  const auto more = fitted_shape(points, 6, {{0.0, 0.0}, {{2.0}, {3.0}, {4.0}, {5.0}}});
  EXPECT_GT(gain_of(right, plain), 0.0);
  EXPECT_LT(gain_of(more, right), 0.0);
}

}  // namespace
}  // namespace hada
