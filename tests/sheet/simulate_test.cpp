#include "sheet/simulate.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// The crease that leaves the middle at this direction.
int crease_at(const Sheet& sheet, double deg) {
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    if (sheet.is_border(h / 2)) continue;
    const Eigen::Vector2d way =
        sheet.flat[std::size_t(sheet.target(h))] - sheet.flat[std::size_t(sheet.origin(h))];
    const bool from_middle = (sheet.flat[std::size_t(sheet.origin(h))].array() == 1.0).all();
    if (from_middle && std::abs(std::atan2(way.y(), way.x()) - deg * degree) < 1e-9) return h / 2;
  }
  return -1;
}

TEST(Simulate, FollowsTheClosedFormOfAVertexOfDegreeFour) {
  // A Miura vertex with sectors of 60 and 120 degrees: tan(minor / 2) = cos(60) tan(major / 2).
  const Sheet sheet = sheet_of(vertex_fold({0, 60, 180, -60}, "MVVV"), "miura");
  const int zigzag = crease_at(sheet, 60), straight = crease_at(sheet, 180);
  ASSERT_GE(zigzag, 0);
  ASSERT_GE(straight, 0);
  for (const double fold : {20.0, 90.0, 150.0}) {
    SimulateOptions options;
    options.held = {{zigzag, fold * degree}};
    const Simulated shape = simulate(sheet, options);
    const double major = shape.angles[std::size_t(zigzag)];
    const double minor = 2.0 * std::atan(std::cos(60.0 * degree) * std::tan(0.5 * major));
    EXPECT_NEAR(major / degree, fold, 0.01);
    EXPECT_NEAR(shape.angles[std::size_t(straight)] / degree, minor / degree, 0.01);
    EXPECT_LT(shape.strain, 1e-9);
  }
}

TEST(Simulate, ReachesTheAngleOfASingleCrease) {
  Lines lines;
  lines.square(1.0).add(Crease::mountain, 0.4, 0.0, 0.6, 1.0);
  const Sheet sheet = sheet_of(lines.frame, "one");
  for (const bool rigid : {true, false}) {
    SimulateOptions options;
    options.share = 0.3;
    options.rigid = rigid;
    const Simulated shape = simulate(sheet, options);
    int creases = 0;
    for (int e = 0; e < sheet.edges(); ++e) {
      if (sheet.is_border(e)) continue;
      EXPECT_NEAR(shape.angles[std::size_t(e)] / degree, -54.0, 1e-4);
      ++creases;
    }
    EXPECT_EQ(creases, 1);
  }
}

TEST(Simulate, RefusesToHoldTheBorder) {
  SimulateOptions options;
  options.held = {{0, 1.0}};
  EXPECT_THROW(simulate(square_sheet(1.0), options), Error);
}

}  // namespace
}  // namespace hada
