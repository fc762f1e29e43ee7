#include "reconstruct/coarse_nodes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "graphs.h"

namespace hada {
namespace {

TEST(CoarseNodes, AreEveryOtherOneOfAPath) {
  const auto graph = lattice_graph(1, 9, [](int, int, bool) { return 2.0f; });
  const auto coarse = coarse_nodes(graph);
  for (int node = 0; node + 1 < 9; ++node) {
    EXPECT_NE(coarse[std::size_t(node)], coarse[std::size_t(node + 1)]) << node;
  }
}

TEST(CoarseNodes, AreThinnedOutAlongStrongEdgesOnly) {
  // Rows that hardly hold together: each is coarsened for itself.
  const auto graph = lattice_graph(4, 9, [](int, int, bool down) { return down ? 1e-3f : 1.0f; });
  const auto coarse = coarse_nodes(graph);
  for (int row = 0; row < 4; ++row) {
    for (int col = 0; col + 1 < 9; ++col) {
      EXPECT_NE(coarse[std::size_t(row * 9 + col)], coarse[std::size_t(row * 9 + col + 1)]);
    }
  }
}

TEST(CoarseNodes, LeaveEveryOtherNodeOneThatItDependsOn) {
  const auto graph = lattice_graph(30, 40, [](int row, int col, bool down) {
    return float(std::pow(10.0, -6.0 * uniform(3, row, col, down)));
  });
  const auto coarse = coarse_nodes(graph);
  const auto heaviest = heaviest_edges(graph);
  int count = 0;
  for (int node = 0; node < graph.rows(); ++node) {
    if (coarse[std::size_t(node)]) {
      ++count;
      continue;
    }
    bool found = false;
    for (std::size_t i = 0; i < graph.columns_of(node).size(); ++i) {
      found |= coarse[std::size_t(graph.columns_of(node)[i])] != 0 &&
               graph.weights_of(node)[i] >= strong_share * heaviest[std::size_t(node)];
    }
    EXPECT_TRUE(found) << node;
  }
  EXPECT_LT(count, 0.6 * graph.rows());
}

}  // namespace
}  // namespace hada
