#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/crease_lines.h"

namespace hada {
namespace {

TEST(CreaseSvg, TellsCreasesByTheirColour) {
  const auto frame = lines_of_svg(
      "<svg><line stroke='red' x1='0' y1='0' x2='1' y2='1' opacity='0.5'/>"
      "<line stroke='#0000ff' x1='0' y1='1' x2='1' y2='0'/>"
      "<path stroke='black' d='M0 0L3 0'/></svg>",
      "a.svg");
  ASSERT_EQ(frame.edges.size(), 3u);
  EXPECT_EQ(frame.crease(0), Crease::mountain);
  EXPECT_EQ(frame.crease(1), Crease::valley);
  EXPECT_EQ(frame.crease(2), Crease::border);
  EXPECT_NEAR(frame.fold_angle_deg[0], -90.0, 1e-9);
}

TEST(CreaseSvg, MovesLinesByTheirTransforms) {
  const auto frame = lines_of_svg(
      "<svg><g transform='scale(2)'><line stroke='red' x1='0' y1='0' x2='3' y2='4'/></g></svg>",
      "a.svg");
  ASSERT_EQ(frame.edges.size(), 1u);
  EXPECT_NEAR((frame.vertices[1] - frame.vertices[0]).norm(), 10.0, 1e-12);
}

TEST(CreaseSvg, ThatIsBrokenOffIsRefused) {
  EXPECT_THROW(lines_of_svg("<svg><line stroke='red' x1='0", "a.svg"), Error);
}

}  // namespace
}  // namespace hada
