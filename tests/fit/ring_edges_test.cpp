#include "fit/ring_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

/// A radius of wood, half a pixel a column: dark grows before each edge and ends within `soft` px.
Unrolled radius_with_edges(const std::vector<double>& edges, double soft) {
  Unrolled flat;
  flat.step = 0.5;
  flat.theta = {0.0};
  flat.values = Grid<float>(1, 300, 0.0f);
  for (int col = 0; col < 300; ++col) {
    double from = 0.0;
    for (const double edge : edges) {
      const double rho = flat.rho(col);
      const double grown = std::clamp((rho - from) / (edge - from), 0.0, 1.0);
      const double ended = 0.5 * (1.0 + std::erf((rho - edge) / (std::sqrt(2.0) * soft)));
      if (rho > from) flat.values(0, col) -= float(std::pow(grown, 3) * (1.0 - ended));
      from = edge;
    }
  }
  return flat;
}

TEST(SlopesAlong, AreThoseOfARamp) {
  std::vector<float> ramp;
  for (int k = 0; k < 60; ++k) ramp.push_back(0.3f * float(k));
  const auto slopes = slopes_along(ramp, 0.5, 1.6);
  EXPECT_TRUE(std::isnan(slopes.front()));
  EXPECT_NEAR(slopes[30], 0.6, 1e-5);  // per px
}

TEST(RingEdges, AreWhereDarkEnds) {
  const auto flat = radius_with_edges({40.0, 75.0, 110.0}, 1.0);
  const auto edges = ring_edges(flat, 1.0);
  ASSERT_EQ(edges.size(), 1u);
  ASSERT_EQ(edges[0].size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double truth = 40.0 + 35.0 * double(k);
    // The dark that grows by 3 / 35 a pixel before the edge moves the steepest place outward, by
    // that times the variance of the blur, 1 + 1.6^2; a column is half a pixel.
    EXPECT_NEAR(edges[0][k].rho, truth + 3.0 / 35.0 * 3.56, 0.05);
    // The darkest place is still 0.8 deep or more: half of that is met at a rise of 0.6, which the
    // soft end reaches 0.25 px further out. The middle of a logarithm 1 deep lies at 0.44 of it,
    // between 0.5 and that of mixed light, 0.38: 0.06 sqrt(2 pi) px further out.
    EXPECT_NEAR(middle_of_rise(edges[0][k], flat, 1.0).rho, truth, 0.4);
    EXPECT_GT(middle_of_rise(edges[0][k], flat, 1.0).rho, truth);
  }
}

TEST(RingEdges, AreFaintBesideThoseNearbyOnly) {
  // The wood inside has a tenth of the contrast of that outside.
  std::vector<double> ends;
  for (int k = 1; k <= 28; ++k) ends.push_back(5.0 * k);
  auto flat = radius_with_edges(ends, 1.0);
  for (int col = 0; col < 150; ++col) flat.values(0, col) *= 0.1f;
  const auto edges = ring_edges(flat, 1.0);
  // Six edges on both sides of an edge count; of the 14 inside, half see few of those outside.
  const auto inside = std::count_if(edges[0].begin(), edges[0].end(),
                                    [](const RingEdge& edge) { return edge.rho < 75.0; });
  EXPECT_GE(inside, 7);
}

/// As many sectors as edges are given for, a whole turn together.
Unrolled turn_of(std::size_t sectors) {
  Unrolled flat;
  flat.values = Grid<float>(int(sectors), 1, 0.0f);
  flat.sector_rad = 2.0 * std::numbers::pi / double(sectors);
  return flat;
}

TEST(RingChains, FollowAnEdgeFromSectorToSector) {
  std::vector<std::vector<RingEdge>> edges;
  for (int s = 0; s < 20; ++s) {
    edges.push_back({{s, 40.0 + 0.3 * s, 1.0}, {s, 80.0, 1.0}});
    if (s == 7) edges.back().erase(edges.back().begin() + 1);  // one sector without
    if (s < 3) edges.back().push_back({s, 120.0, 1.0});        // too short to be kept
  }
  const auto chains = ring_chains(edges, turn_of(edges.size()), 1.0);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].size(), 20u);
  EXPECT_EQ(chains[1].size(), 19u);
}

TEST(RingChains, AreNotMadeOfOneViewSeenTwice) {
  // Forty sectors go around a ring of 12 px in 75 px: those of 16 px share what they see with one
  // neighbour on each side at least, so that the same noise goes on from one to the next.
  std::vector<std::vector<RingEdge>> edges(40);
  for (int s = 0; s < 40; ++s) {
    if (s < 11) edges[std::size_t(s)].push_back({s, 12.0, 1.0});
    if (s < 11) edges[std::size_t(s)].push_back({s, 200.0, 1.0});
  }
  auto flat = turn_of(edges.size());
  flat.joined = 16.0;
  ASSERT_GE(flat.joined_at(12.0), 1);
  ASSERT_EQ(flat.joined_at(200.0), 0);
  const auto chains = ring_chains(edges, flat, 1.0);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].front().rho, 200.0);
}

}  // namespace
}  // namespace hada
