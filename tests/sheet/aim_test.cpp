#include "sheet/aim.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

class AimOnASquare : public testing::Test {
 protected:
  Aim at(double x, double y) const {
    const Vector3d eye(0.5, 0.5, 4.0);
    const auto found =
        aim(sheet_, stack_of(sheet_, {}), {eye, Vector3d(x, y, 0.0) - eye}, options_);
    EXPECT_TRUE(found);
    return found.value_or(Aim{});
  }
  const Sheet sheet_ = square_sheet(1.0);
  AimOptions options_ = {.edge_parts = 2, .corner_parts = 4, .reach = 0.03};
};

TEST_F(AimOnASquare, PrefersCornersToDivisionsToPaper) {
  EXPECT_EQ(at(0.02, 0.01).by, Drawn::vertex);
  const Aim middle = at(0.51, 0.02);
  EXPECT_EQ(middle.by, Drawn::division);
  EXPECT_LT((middle.place - Vector3d(0.5, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(middle.points.size(), 1u);
  const Aim paper = at(0.3, 0.45);
  EXPECT_EQ(paper.by, Drawn::paper);
  EXPECT_EQ(paper.face, 0);
  const Aim beside = at(1.4, 0.45);
  EXPECT_EQ(beside.by, Drawn::ground);
  EXPECT_LT((beside.place - Vector3d(1.4, 0.45, 0.0)).norm(), 1e-12);
}

TEST_F(AimOnASquare, FindsThePointsOfTheBirdBaseWhereGuidesCross) {
  const double t = 0.5 * std::tan(std::numbers::pi / 8.0);
  EXPECT_LT((at(0.49, 0.505).place - Vector3d(0.5, 0.5, 0.0)).norm(), 1e-12);
  const Aim crossing = at(t + 0.005, 0.495);
  EXPECT_EQ(crossing.by, Drawn::crossing);
  EXPECT_LT((crossing.place - Vector3d(t, 0.5, 0.0)).norm(), 1e-12);
  EXPECT_GE(crossing.guides.size(), 2u);
}

TEST_F(AimOnASquare, FollowsADirectionBeyondThePaper) {
  options_.start = Vector3d(0.0, 0.0, 0.0);
  const double slope = std::tan(std::numbers::pi / 8.0);
  const Aim inside = at(0.3, 0.3 * slope + 0.01), outside = at(1.5, 1.5 * slope + 0.01);
  for (const Aim& found : {inside, outside}) {
    EXPECT_EQ(found.by, Drawn::direction);
    EXPECT_EQ(found.guides.size(), 3u);
    EXPECT_NEAR(found.place.y(), slope * found.place.x(), 1e-12);
  }
}

TEST_F(AimOnASquare, FollowsADirectionFromInsideAnEdge) {
  options_.start = Vector3d(0.25, 0.0, 0.0);
  options_.corner_parts = 8;
  const double slope = std::tan(std::numbers::pi * 3.0 / 8.0);
  for (const double y : {0.3, 1.7}) {
    const Aim found = at(0.25 + y / slope + 0.01, y);
    EXPECT_EQ(found.by, Drawn::direction);
    EXPECT_EQ(found.guides.size(), 7u);
    EXPECT_NEAR(found.place.y(), slope * (found.place.x() - 0.25), 1e-12);
  }
}

TEST_F(AimOnASquare, TakesLinesThatWaitForEdges) {
  options_.lines = {{Vector3d(0.2, 0.1, 0.0), Vector3d(0.2, 0.9, 0.0)}};
  EXPECT_LT((at(0.21, 0.11).place - Vector3d(0.2, 0.1, 0.0)).norm(), 1e-15);
  // The diagonal of the corner crosses it.
  const Aim crossing = at(0.205, 0.2);
  EXPECT_EQ(crossing.by, Drawn::crossing);
  EXPECT_LT((crossing.place - Vector3d(0.2, 0.2, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace hada
