#include "mechanics/worn_knit.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(WornKnit, CountsSpringsAndFacesOfATube) {
  WornKnit knit;
  knit.net.courses = 3, knit.net.wales = 4, knit.net.round = true;
  knit.net.stiffness = {1.0, 10.0, 1.0};
  const auto springs = springs_of(knit);
  ASSERT_EQ(springs.size(), 20u);
  EXPECT_EQ(springs[3].from, 3);
  EXPECT_EQ(springs[3].to, 0);
  EXPECT_EQ(springs[5].stiffness, 10.0);
  const auto cells = cells_of(knit);
  ASSERT_EQ(cells.size(), 8u);
  // The sides of each face are the springs between its corners.
  for (const ShellCell& cell : cells) {
    for (const int s : cell.springs) {
      for (const int end : {springs[std::size_t(s)].from, springs[std::size_t(s)].to}) {
        EXPECT_EQ(std::count(cell.corners.begin(), cell.corners.end(), end), 1);
      }
    }
  }
  EXPECT_EQ(course_of(knit, 6), 1);
  EXPECT_EQ(wale_of(knit, 6), 2);
}

}  // namespace
}  // namespace hada
