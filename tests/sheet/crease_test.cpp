#include "sheet/crease.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<Vector3d> flat_places(const Sheet& sheet) {
  std::vector<Vector3d> places;
  for (const auto& p : sheet.flat) places.emplace_back(p.x(), p.y(), 0.0);
  return places;
}

std::vector<int> draw(Sheet& sheet, const Vector2d& from, const Vector2d& to) {
  return insert_crease(sheet, flat_places(sheet), straight_cut(from, to, 1e-9), Crease::valley);
}

// What every sheet must obey, however it was cut.
void expect_sound(const Sheet& sheet) {
  EXPECT_EQ(sheet.vertices() - sheet.edges() + sheet.faces(), 1);
  double area = 0.0;
  std::vector<int> seen(sheet.halves.size(), 0);
  for (int f = 0; f < sheet.faces(); ++f) {
    for (const int h : sheet.halves_of(f)) {
      EXPECT_EQ(sheet.half(h).face, f);
      ++seen[std::size_t(h)];
      const Vector2d &a = sheet.flat[std::size_t(sheet.origin(h))],
                     &b = sheet.flat[std::size_t(sheet.target(h))];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }
  EXPECT_NEAR(area, 1.0, 1e-12);
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    EXPECT_EQ(seen[std::size_t(h)], sheet.half(h).face >= 0 ? 1 : 0);
    EXPECT_EQ(sheet.origin(sheet.half(h).next), sheet.target(h));
  }
}

TEST(Crease, CutsAllFacesThatItMeets) {
  Sheet sheet = square_sheet(1.0);
  EXPECT_EQ(draw(sheet, {0.5, -1}, {0.5, 2}).size(), 1u);
  expect_sound(sheet);
  EXPECT_EQ(draw(sheet, {-1, 0.25}, {2, 0.25}).size(), 2u);
  expect_sound(sheet);
  EXPECT_EQ(sheet.faces(), 4);
  EXPECT_EQ(draw(sheet, {-1, -1}, {2, 2}).size(), 3u);  // three faces, through the corners too
  expect_sound(sheet);
}

TEST(Crease, RunsThroughCornersAndAlongEdges) {
  Sheet sheet = square_sheet(1.0);
  draw(sheet, {0, 0}, {1, 1});
  draw(sheet, {0, 1}, {1, 0});
  EXPECT_EQ(sheet.faces(), 4);
  EXPECT_EQ(sheet.vertices(), 5);
  expect_sound(sheet);
  const auto again = draw(sheet, {0, 0}, {1, 1});
  EXPECT_EQ(again.size(), 2u);  // found, not made
  EXPECT_EQ(sheet.faces(), 4);
}

TEST(Crease, LeavesAFaceWholeThatItDoesNotLeave) {
  Sheet sheet = square_sheet(1.0);
  EXPECT_TRUE(draw(sheet, {-1, 0.5}, {0.5, 0.5}).empty());
  EXPECT_EQ(sheet.faces(), 1);
  expect_sound(sheet);
}

}  // namespace
}  // namespace hada
