#include "reconstruct/interpolation.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random.h"
#include "graphs.h"
#include "reconstruct/coarse_nodes.h"

namespace hada {
namespace {

TEST(Interpolation, FollowsTheWeightsAlongAPath) {
  // 0 =3= 1 =1= 2: where no force acts, node 1 lies a quarter of the way from node 0 to node 2.
  const auto graph = lattice_graph(1, 3, [](int, int col, bool) { return col == 0 ? 3.0f : 1.0f; });
  const SparseRows shares = interpolation(graph, {1, 0, 1});
  ASSERT_EQ(shares.columns, 2);
  ASSERT_EQ(shares.columns_of(1).size(), 2u);
  EXPECT_EQ(shares.weights_of(1)[0], 0.75f);
  EXPECT_EQ(shares.weights_of(1)[1], 0.25f);
  // And the two edges in series are one of 1 / (1 / 3 + 1 / 1).
  const SparseRows coarse = coarse_graph(graph, shares);
  ASSERT_EQ(coarse.columns_of(0).size(), 1u);
  EXPECT_EQ(coarse.columns_of(0)[0], 1);
  EXPECT_EQ(coarse.weights_of(0)[0], 0.75f);
}

TEST(Interpolation, SeesThroughFineNodes) {
  // c 1 f 1 f 1 c, all edges alike: f lies at a third of the way; the equation of the other f is
  // put in, 2 f' = f + c', so 2 f = c + (f + c') / 2.
  const auto graph = lattice_graph(1, 4, [](int, int, bool) { return 1.0f; });
  const SparseRows shares = interpolation(graph, {1, 0, 0, 1});
  ASSERT_EQ(shares.columns_of(1).size(), 2u);
  EXPECT_NEAR(shares.weights_of(1)[0], 2.0f / 3.0f, 1e-7f);
  EXPECT_NEAR(shares.weights_of(1)[1], 1.0f / 3.0f, 1e-7f);
}

TEST(Interpolation, SharesAddUpToOneExactly) {
  const auto graph = lattice_graph(30, 40, [](int row, int col, bool down) {
    return float(std::pow(10.0, -6.0 * uniform(4, row, col, down)));
  });
  const SparseRows shares = interpolation(graph, coarse_nodes(graph));
  for (int node = 0; node < graph.rows(); ++node) {
    const auto of_node = shares.weights_of(node);
    EXPECT_EQ(std::accumulate(of_node.begin(), of_node.end(), 0.0), 1.0);
  }
}

TEST(CoarseGraph, HasTheEnergyOfTheValuesCarried) {
  const auto graph = lattice_graph(
      12, 15, [](int row, int col, bool down) { return float(0.1 + uniform(5, row, col, down)); });
  const SparseRows shares = interpolation(graph, coarse_nodes(graph));
  const SparseRows coarse = coarse_graph(graph, shares);
  std::vector<double> small(std::size_t(coarse.rows()));
  for (std::size_t i = 0; i < small.size(); ++i) small[i] = gaussian(6, int(i));
  std::vector<double> large(std::size_t(graph.rows()), 0.0);
  for (int node = 0; node < graph.rows(); ++node) {
    for (std::size_t i = 0; i < shares.columns_of(node).size(); ++i) {
      large[std::size_t(node)] +=
          double(shares.weights_of(node)[i]) * small[std::size_t(shares.columns_of(node)[i])];
    }
  }
  const auto energy = [](const SparseRows& of, const std::vector<double>& values) {
    double sum = 0.0;
    for (int node = 0; node < of.rows(); ++node) {
      for (std::size_t i = 0; i < of.columns_of(node).size(); ++i) {
        sum += of.weights_of(node)[i] *
               std::pow(values[std::size_t(of.columns_of(node)[i])] - values[std::size_t(node)], 2);
      }
    }
    return sum;
  };
  EXPECT_NEAR(energy(coarse, small) / energy(graph, large), 1.0, 1e-6);  // weights are floats
}

}  // namespace
}  // namespace hada
