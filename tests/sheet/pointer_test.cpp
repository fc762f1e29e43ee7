#include "sheet/pointer.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

Ray down_to(double x, double y) {
  return {{0.5, 0.5, 10.0}, Vector3d(x, y, 0.0) - Vector3d(0.5, 0.5, 10.0)};
}

// A unit square with creases x = 1/4 and x = 3/4.
Sheet three_panels() {
  Sheet sheet = square_sheet(1.0);
  for (const double x : {0.25, 0.75}) {
    insert_crease(sheet, sheet.folded, straight_cut({x, -1}, {x, 2}, 1e-9), Crease::flat);
  }
  return sheet;
}

TEST(Pointer, HitsTheNearestFace) {
  Sheet sheet = three_panels();
  const auto found = hit(sheet, down_to(0.5, 0.4));
  ASSERT_TRUE(found);
  EXPECT_LT((found->place - Vector3d(0.5, 0.4, 0.0)).norm(), 1e-14);
  EXPECT_FALSE(hit(sheet, down_to(1.5, 0.5)));
  EXPECT_FALSE(hit(sheet, {{0.5, 0.5, 10.0}, {0.0, 0.0, 1.0}}));
}

TEST(Pointer, DrawsACreaseThroughAllFacesBetweenItsRays) {
  Sheet sheet = three_panels();
  const auto edges = insert_crease(sheet, sheet.folded,
                                   drawn_cut(down_to(-0.1, 0.3), down_to(1.1, 0.6)), Crease::flat);
  EXPECT_EQ(edges.size(), 3u);
  Sheet part = three_panels();
  const auto some = insert_crease(part, part.folded,
                                  drawn_cut(down_to(-0.1, 0.3), down_to(0.5, 0.3)), Crease::flat);
  EXPECT_EQ(some.size(), 1u);  // the drag ends within the second panel
}

TEST(Pointer, SnapsToCornersThenToDivisions) {
  const Sheet sheet = square_sheet(1.0);
  const auto corner = snapped(sheet, 0, down_to(0.01, 0.02), 0.05, 4);
  ASSERT_TRUE(corner);
  EXPECT_GE(corner->vertex, 0);
  EXPECT_LT(corner->place.norm(), 1e-15);
  const auto quarter = snapped(sheet, 0, down_to(0.26, 0.01), 0.05, 4);
  ASSERT_TRUE(quarter);
  EXPECT_EQ(quarter->vertex, -1);
  EXPECT_LT((quarter->place - Vector3d(0.25, 0, 0)).norm(), 1e-15);
  EXPECT_FALSE(snapped(sheet, 0, down_to(0.4, 0.4), 0.05, 4));
}

TEST(Pointer, DividesTheAngleOfACorner) {
  const Sheet sheet = square_sheet(1.0);
  const auto thirds = corner_directions(sheet, 0, 0, 3);
  ASSERT_EQ(thirds.size(), 2u);
  const double third = std::numbers::pi / 6.0;
  EXPECT_LT((thirds[0] - Vector3d(std::cos(third), std::sin(third), 0)).norm(), 1e-15);
}

TEST(Pointer, TakesTheCreaseAcrossTheCentreFromTheClick) {
  const Sheet sheet = three_panels();
  const auto middle = hit(sheet, down_to(0.5, 0.5));
  ASSERT_TRUE(middle);
  const int right = axis_of_click(sheet, middle->face, {0.3, 0.5, 0.0});
  const int left = axis_of_click(sheet, middle->face, {0.7, 0.5, 0.0});
  ASSERT_GE(right, 0);
  ASSERT_GE(left, 0);
  EXPECT_EQ(sheet.flat[std::size_t(sheet.origin(2 * right))].x(), 0.75);
  EXPECT_EQ(sheet.flat[std::size_t(sheet.origin(2 * left))].x(), 0.25);
}

TEST(Pointer, TurnsWhatWasClickedUnderThePointer) {
  // About the x axis; clicked at y = 1, the eye far along x looks back at the plane x = 0.
  const Vector3d along = Vector3d::UnitX(), click(0.0, 1.0, 0.0);
  for (const double angle : {0.3, 1.2, -2.0, 3.0}) {
    const Vector3d there(0.0, std::cos(angle), std::sin(angle));
    const Ray pointer{{9.0, 2.0, 3.0}, there - Vector3d(9.0, 2.0, 3.0)};
    const auto found = angle_of_drag({5.0, 0.0, 0.0}, along, click, pointer);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, angle, 1e-14);
  }
  EXPECT_FALSE(angle_of_drag({0, 0, 0}, along, click, {{0, 0, 5}, {0, 0, -1}}));
  EXPECT_TRUE(should_turn_view(along, {{0, 0, 5}, {0, 0, -1}}));
  EXPECT_FALSE(should_turn_view(along, {{5, 0, 0}, {-1, 0, 0}}));
}

}  // namespace
}  // namespace hada
