#include "sheet/arrangement.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector2d;

double area(const Arrangement& cut, const std::vector<int>& cell) {
  double twice = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Vector2d& a = cut.points[std::size_t(cell[i])];
    const Vector2d& b = cut.points[std::size_t(cell[(i + 1) % cell.size()])];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(Arrangement, OfRandomChordsFillsTheCircleAndObeysEuler) {
  // Chords between points of a polygon: cells tile it, and crossings are counted by pairs.
  constexpr int corners = 24, chords = 12;
  std::vector<Vector2d> places;
  std::vector<std::array<int, 2>> lines;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * (i + 0.8 * uniform(7, i)) / corners;
    places.emplace_back(std::cos(angle), std::sin(angle));
    lines.push_back({i, (i + 1) % corners});
  }
  int crossings = 0;
  for (int i = 0; i < chords; ++i) {
    const int a = int(corners * uniform(9, i, 0)),
              b = (a + 2 + int(9 * uniform(9, i, 1))) % corners;
    const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
    if (std::find(lines.begin(), lines.end(), ends) != lines.end()) continue;
    for (std::size_t j = corners; j < lines.size(); ++j) {
      const auto [c, d] = lines[j];
      crossings += (ends[0] < c && c < ends[1] && ends[1] < d) ||
                   (c < ends[0] && ends[0] < d && d < ends[1]);
    }
    lines.push_back(ends);
  }
  const auto cut = arrangement(places, lines, 1e-9);
  EXPECT_EQ(int(cut.points.size()), corners + crossings);
  EXPECT_EQ(cut.points.size() + cut.cells.size(), cut.segments.size() + 1);
  double sum = 0.0;
  for (const auto& cell : cut.cells) sum += area(cut, cell);
  std::vector<int> rim;
  for (int i = 0; i < corners; ++i) rim.push_back(cut.point_of[std::size_t(i)]);
  EXPECT_NEAR(sum, area(cut, rim), 1e-12);  // rounding of some hundred terms near 1
}

TEST(Arrangement, CutsALineWhereAnotherEndsOnIt) {
  const auto cut = arrangement({{0, 0}, {2, 0}, {1, 1e-12}, {1, 1}}, {{0, 1}, {3, 2}}, 1e-9);
  EXPECT_EQ(cut.segments.size(), 3u);
  EXPECT_EQ(cut.segments_of[0].size(), 2u);
  EXPECT_EQ(cut.segments_of[1].size(), 1u);
}

TEST(Arrangement, SharesWhatLinesHaveInCommon) {
  const auto cut = arrangement({{0, 0}, {2, 0}, {1, 0}, {3, 0}}, {{0, 1}, {2, 3}}, 1e-9);
  EXPECT_EQ(cut.segments.size(), 3u);
  EXPECT_EQ(cut.segments_of[0][1], cut.segments_of[1][0]);
}

TEST(SnapDistance, LiesBetweenRoundingAndDrawing) {
  std::vector<Vector2d> places;
  for (int i = 0; i < 20; ++i) {
    places.emplace_back(i * 0.006, 0.1 * i);
    places.emplace_back(i * 0.006 + 1e-9 * uniform(3, i), 0.1 * i);
  }
  const double snap = snap_distance(places, {});
  EXPECT_GT(snap, 1e-9);
  EXPECT_LT(snap, 0.006);
}

}  // namespace
}  // namespace hada
