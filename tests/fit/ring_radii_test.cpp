#include "fit/ring_radii.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

constexpr int sectors = 90;
constexpr double pi = std::numbers::pi;

/// A stem laid flat, half a pixel a column, whose rings end where `radius(k, theta)` says: it
/// darkens towards each end and is light again beyond.
template <class Radius>
Unrolled stem(int rings, const Radius& radius) {
  Unrolled flat;
  flat.step = 0.5;
  flat.sector_rad = 2.0 * pi / sectors;
  flat.whole_turn = true;
  flat.values = Grid<float>(sectors, 400, 0.0f);
  for (int s = 0; s < sectors; ++s) {
    flat.theta.push_back((s + 0.5) * flat.sector_rad);
    for (int col = 0; col < 400; ++col) {
      double from = 0.0;
      for (int k = 0; k < rings; ++k) {
        const double end = radius(k, flat.theta.back());
        const double rho = flat.rho(col);
        if (rho >= from && rho < end)
          flat.values(s, col) = float(-std::pow((rho - from) / (end - from), 3));
        from = end;
      }
    }
  }
  return flat;
}

TEST(RingRadii, AreWhereAllSectorsSeeARingEnd) {
  const auto flat = stem(4, [](int k, double) { return 30.0 * (k + 1); });
  const auto radii = ring_radii(flat, 1.0);
  ASSERT_EQ(radii.size(), 4u);
  // An end lies between two columns half a pixel apart.
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(radii[std::size_t(k)], 30.0 * (k + 1), 0.5);
}

TEST(WanderingRings, AreFoundWhereAllSectorsTogetherSeeNothing) {
  // The second ring of four swings by 12 px, the others keep still.
  const auto flat = stem(4, [](int k, double theta) {
    return 30.0 * (k + 1) + (k == 1 ? 12.0 * std::sin(2.0 * theta) : 0.0);
  });
  const auto edges = ring_edges(flat, 1.0);
  const auto radii = ring_radii(flat, 1.0);
  const auto chains = ring_chains(edges, flat, 1.0);
  std::vector<RingChain> still;
  for (const double radius : {30.0, 90.0, 120.0}) {
    for (auto& ring : edges_of_rings({radius}, edges, flat, 3.0, 1.0))
      still.push_back(std::move(ring));
  }
  const auto found = wandering_rings(still, chains, flat, 3.0, 1.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GE(found[0].size(), std::size_t(sectors) / 2);
  for (const RingEdge& edge : found[0]) {
    const double theta = flat.theta[std::size_t(edge.sector)];
    EXPECT_NEAR(edge.rho, 60.0 + 12.0 * std::sin(2.0 * theta), 1.0);
  }
}

TEST(WanderingRings, AreNotMadeOfShortPieces) {
  // A second ring that goes a quarter of the way around only.
  const auto flat = stem(3, [](int k, double theta) {
    if (k != 1) return k == 0 ? 30.0 : 90.0;
    return theta < 0.5 * pi ? 60.0 : 89.9;
  });
  const auto edges = ring_edges(flat, 1.0);
  std::vector<RingChain> still;
  for (const double radius : {30.0, 90.0}) {
    for (auto& ring : edges_of_rings({radius}, edges, flat, 3.0, 1.0))
      still.push_back(std::move(ring));
  }
  EXPECT_TRUE(wandering_rings(still, ring_chains(edges, flat, 1.0), flat, 3.0, 1.0).empty());
}

TEST(StandsOut, WhatSectorsAgreeOnAndNoNoise) {
  auto flat = stem(3, [](int k, double theta) {
    return 30.0 * (k + 1) + (k == 1 ? 4.0 * std::sin(2.0 * theta) : 0.0);
  });
  for (int s = 0; s < sectors; ++s) {
    for (int col = 0; col < 400; ++col) flat.values(s, col) += float(0.15 * gaussian(11, s, col));
  }
  RingChain ring, noise;
  for (int s = 0; s < sectors; ++s) {
    ring.push_back({s, 60.0 + 4.0 * std::sin(2.0 * flat.theta[std::size_t(s)]), 1.0});
    // The steepest place of each sector within 3 px of where nothing is.
    const auto slopes = slopes_along(flat.values.row(s), 0.5, 1.0);
    const auto steepest = std::max_element(slopes.begin() + 264, slopes.begin() + 276);
    noise.push_back({s, flat.rho(double(steepest - slopes.begin())), 1.0});
  }
  EXPECT_TRUE(stands_out(ring, flat, 1.0));
  EXPECT_FALSE(stands_out(noise, flat, 1.0));
}

TEST(RadiusOf, IsTheMiddleOne) {
  EXPECT_DOUBLE_EQ(radius_of({{0, 1.0, 1.0}, {1, 5.0, 1.0}, {2, 2.0, 1.0}}), 2.0);
}

}  // namespace
}  // namespace hada
