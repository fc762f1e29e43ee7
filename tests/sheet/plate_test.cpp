#include "sheet/plate.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

Plate plate(const std::vector<Vector3d>& corners) {
  std::vector<int> all;
  for (int i = 0; i < int(corners.size()); ++i) all.push_back(i);
  return plate_of(all, corners);
}

const Plate square = plate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});

TEST(Plate, PiercesOnlyWhereBothReachThrough) {
  // A wall as wide as the square, so that no side goes through the inside of the other.
  EXPECT_TRUE(pierce(square, plate({{0.5, 0, -1}, {0.5, 1, -1}, {0.5, 1, 1}, {0.5, 0, 1}}), 1e-6));
  // It stands on it, it stands beside it, it shares a side.
  EXPECT_FALSE(pierce(square, plate({{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 1, 1}, {0.5, 0, 1}}), 1e-6));
  EXPECT_FALSE(pierce(square, plate({{1.1, 0, -1}, {1.1, 1, -1}, {1.1, 1, 1}, {1.1, 0, 1}}), 1e-6));
  EXPECT_FALSE(pierce(square, plate({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}), 1e-6));
  // In by less than the tolerance.
  const Plate grazing = plate({{0.5, 0, -1e-7}, {0.5, 1, -1e-7}, {0.5, 1, 1}, {0.5, 0, 1}});
  EXPECT_FALSE(pierce(square, grazing, 1e-6));
  EXPECT_TRUE(pierce(square, grazing, 1e-8));
}

TEST(Plate, FindsWhatIsCommon) {
  const auto shifted = [](double x, double z) {
    return plate({{x, 0, z}, {x, 1, z}, {x + 1, 1, z}, {x + 1, 0, z}});  // seen from below
  };
  const auto place = common_place(shifted(0.5, 0.0), square, 1e-6);
  ASSERT_TRUE(place);
  EXPECT_NEAR((*place - Vector3d(0.75, 0.5, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_FALSE(common_place(shifted(1.0, 0.0), square, 1e-6));  // side by side
  EXPECT_FALSE(common_place(shifted(0.5, 1e-3), square, 1e-6));
}

TEST(Plate, TakesMarksAlong) {
  const Plate moved = plate({{3, 1, 2}, {3, 2, 2}, {3, 2, 3}, {3, 1, 3}});
  const Vector3d place(0.2, 0.7, 0.0);
  EXPECT_NEAR((marked_place(square, mark_on(square, place)) - place).norm(), 0.0, 1e-15);
  EXPECT_NEAR((marked_place(moved, mark_on(square, place)) - Vector3d(3, 1.2, 2.7)).norm(), 0.0,
              1e-15);
}

}  // namespace
}  // namespace hada
