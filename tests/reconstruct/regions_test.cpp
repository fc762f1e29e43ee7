#include "reconstruct/regions.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Regions, JoinAlongEdgesButNotAcrossCorners) {
  Mask mask(3, 4, 0);
  mask(0, 0) = mask(0, 1) = mask(1, 1) = 1;  // an L
  mask(2, 2) = mask(2, 3) = 1;               // touches it at a corner
  const Regions regions = regions_of(mask);
  EXPECT_EQ(regions.size, (std::vector<int>{7, 3, 2}));
  EXPECT_EQ(regions.label(0, 0), regions.label(1, 1));
  EXPECT_NE(regions.label(1, 1), regions.label(2, 2));
  EXPECT_EQ(regions.label(0, 3), 0);
}

TEST(Regions, JoinWhatMeetsFurtherDown) {
  // A comb whose teeth touch in the last row alone; an island between them; a second comb upside
  // down.
  const std::vector<std::string> picture = {"#.#.#..###",  //
                                            "#.#.#..#.#",  //
                                            "#...#..#.#",  //
                                            "#.#.#....#",  //
                                            "#####....."};
  Mask mask(5, 10, 0);
  for (int row = 0; row < 5; ++row) {
    for (int col = 0; col < 10; ++col) {
      mask(row, col) = picture[std::size_t(row)][std::size_t(col)] == '#';
    }
  }
  const Regions regions = regions_of(mask);
  EXPECT_EQ(regions.size, (std::vector<int>{26, 14, 2, 8}));
  EXPECT_EQ(regions.label(0, 0), 1);
  EXPECT_EQ(regions.label(0, 4), 1);
  EXPECT_EQ(regions.label(3, 2), 1);
  EXPECT_EQ(regions.label(1, 2), 2);
  EXPECT_EQ(regions.label(3, 9), 3);
  EXPECT_EQ(regions.label(2, 8), 0);
  EXPECT_EQ(regions.row(1).size(), 5u);
}

}  // namespace
}  // namespace hada
