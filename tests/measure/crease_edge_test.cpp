#include "measure/crease_edge.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector2d;

// A bend of this width across a line, on a lattice of pitch 0.5 that knows nothing of the line.
std::vector<StepSample> samples(const CreaseEdge& edge, double noise, Seed seed) {
  std::vector<StepSample> all;
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) {
      const Vector2d place(0.5 * (col - 30), 0.5 * (row - 30));
      const double z = (edge.normal.dot(place) - edge.offset) / edge.width;
      if (std::abs(z * edge.width) > 6.0) continue;
      const double passed = 0.5 * std::erfc(-z / std::numbers::sqrt2);
      all.push_back({place, passed + noise * gaussian(seed, row, col)});
    }
  }
  return all;
}

CreaseEdge edge_at(double deg, double offset, double width) {
  CreaseEdge edge;
  const double angle = deg * std::numbers::pi / 180.0;
  edge.normal = {std::cos(angle), std::sin(angle)};
  edge.offset = offset;
  edge.width = width;
  return edge;
}

TEST(CreaseEdge, WithoutNoiseIsFoundExactly) {
  const CreaseEdge truth = edge_at(25.0, 1.3, 0.8);
  const CreaseEdge found = fitted_edge(samples(truth, 0.0, 1), edge_at(22.0, 1.8, 0.5));
  EXPECT_NEAR(found.offset, truth.offset, 1e-6);
  EXPECT_NEAR(found.width, truth.width, 1e-6);
  EXPECT_NEAR((found.normal - truth.normal).norm(), 0.0, 1e-6);
}

TEST(CreaseEdge, IsKnownAsWellAsItSays) {
  int offsets = 0, widths = 0, turns = 0;
  constexpr int runs = 60;
  for (Seed seed = 1; seed <= runs; ++seed) {
    const CreaseEdge truth = edge_at(10.0 + 3.0 * double(seed), 0.7, 1.1);
    const auto seen = samples(truth, 0.1, seed);
    const CreaseEdge found = fitted_edge(seen, edge_at(8.0 + 3.0 * double(seed), 0.4, 0.7));
    // The offset is that of the place nearest to the middle of the samples.
    const double turn =
        std::asin(truth.normal.x() * found.normal.y() - truth.normal.y() * found.normal.x());
    Vector2d centre = Vector2d::Zero();
    for (const StepSample& sample : seen) centre += sample.place / double(seen.size());
    const double off =
        (found.offset - found.normal.dot(centre)) - (truth.offset - truth.normal.dot(centre));
    offsets += std::abs(off) < 1.645 * found.offset_sigma;
    widths += std::abs(found.width - truth.width) < 1.645 * found.width_sigma;
    turns += std::abs(turn) < 1.645 * found.turn_sigma;
  }
  // 54 of 60 on average, standard deviation 2.3: within three of it.
  for (const int within : {offsets, widths, turns}) {
    EXPECT_GE(within, 47);
  }
  // And it does not say less than it knows.
  EXPECT_LT(offsets + widths + turns, 3 * runs);
}

TEST(CreaseEdge, OfTooFewSamplesIsLeftAlone) {
  const CreaseEdge start = edge_at(5.0, 0.1, 0.2);
  auto few = samples(edge_at(25.0, 1.3, 0.8), 0.0, 1);
  few.resize(7);
  EXPECT_EQ(fitted_edge(few, start).offset, start.offset);
}

}  // namespace
}  // namespace hada
