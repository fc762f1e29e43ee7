#include "reconstruct/extra_nodes.h"

#include <gtest/gtest.h>

#include "reconstruct/coarsen.h"

namespace hada {
namespace {

/// A level with one extra node: a block whose two cells touch at a corner only.
PixelLevel with_one_extra() {
  Mask mask(6, 6, 1);
  mask(2, 3) = mask(3, 2) = 0;
  PixelLevel fine = PixelLevel::of(mask);
  return coarsened(fine, 0.1f);
}

TEST(ExtraNodes, RelaxToWhereTheirEquationHolds) {
  const PixelLevel level = with_one_extra();
  ASSERT_EQ(level.extras.size(), 1u);
  const std::size_t node = level.at.size();
  Cells x(level.nodes(), 2.0f), right(level.nodes(), 0.0f);
  relax_extras(level, x, right, false);
  EXPECT_FLOAT_EQ(x[node], 2.0f);  // the mean of its neighbours
  right[node] = 1.0f;
  relax_extras(level, x, right, true);
  EXPECT_FLOAT_EQ(x[node], level.inverse[node]);  // all others count as 0
}

TEST(ExtraNodes, PullAtCellsOnlyWhileTheyAreToldTo) {
  const PixelLevel level = with_one_extra();
  Cells x(level.nodes(), 0.0f), right(level.nodes(), 0.5f);
  x[level.at.size()] = 3.0f;
  const Cells was = right;
  {
    const PulledByExtras pulled(level, x, right);
    for (const auto& edge : level.edges)
      EXPECT_FLOAT_EQ(right[std::size_t(edge.to)], 0.5f + 3.0f * edge.weight);
  }
  EXPECT_EQ(right, was);
}

}  // namespace
}  // namespace hada
