#include "reconstruct/extra_edges.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

using Node = PixelLevel::Node;

// A lattice of 2 x 3 cells and two extra nodes, in the cells (0, 1) and (1, 2).
PixelLevel two_extras() {
  PixelLevel level;
  level.at = Dealt(2, 3);
  for (auto* array :
       {&level.east, &level.south, &level.inverse, &level.reach_across, &level.reach_along}) {
    array->assign(level.at.size() + 2, 0.0f);
  }
  level.extras = {{0, 1, 2.0f, 0.0f, 0}, {1, 2, 0.0f, 1.0f, 0}};
  return level;
}

TEST(ExtraEdges, KnowTheCellOfANodeAndTheWayToAnother) {
  const PixelLevel level = two_extras();
  const Place cell = place_of(level, Node(level.at.cell(1, 2)));
  EXPECT_EQ(cell.row, 1);
  EXPECT_EQ(cell.col, 2);
  const Place extra = place_of(level, Node(level.at.size()));
  EXPECT_EQ(extra.row, 0);
  EXPECT_EQ(extra.col, 1);
  EXPECT_EQ(way_between({0, 1}, {0, 1}), Way::within);
  EXPECT_EQ(way_between({0, 1}, {0, 2}), Way::across);
  EXPECT_EQ(way_between({0, 1}, {1, 1}), Way::along);
}

TEST(ExtraEdges, AddUpAndAreListedAtEveryExtraNode) {
  PixelLevel level = two_extras();
  const auto first = Node(level.at.size());
  const Node second = first + 1;
  const auto cell = Node(level.at.cell(0, 0));
  list_extra_edges({{first, second, 1.0f}, {cell, first, 0.5f}, {cell, first, 1.5f}}, level);
  ASSERT_EQ(level.edges.size(), 3u);
  EXPECT_EQ(level.extras[1].first_edge, 2);
  EXPECT_EQ(level.edges[0].to, cell);
  EXPECT_EQ(level.edges[0].weight, 2.0f);
  EXPECT_EQ(level.edges[1].to, second);
  EXPECT_EQ(level.edges[2].to, first);
}

TEST(ExtraEdges, AreInSeriesWithTheHalvesOfTheirEnds) {
  PixelLevel level = two_extras();
  const auto first = Node(level.at.size());
  const auto cell = Node(level.at.cell(0, 0));
  list_extra_edges({{cell, first, 2.0f}}, level);
  add_extra_edges(level);
  // 1 / (1 / 2 + 1 / (2 * 2)): the edge and half of the extra node, whose inside is 2 across; the
  // cell has no inside.
  EXPECT_FLOAT_EQ(level.edges[0].weight, 4.0f / 3.0f);
  EXPECT_FLOAT_EQ(level.inverse[std::size_t(first)], 0.75f);
  EXPECT_FLOAT_EQ(level.inverse[std::size_t(cell)], 0.75f);
}

}  // namespace
}  // namespace hada
