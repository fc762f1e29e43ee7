#include "reconstruct/algebraic_multigrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random.h"
#include "graphs.h"

namespace hada {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::vector<double> image(const SparseRows& graph, const std::vector<double>& x) {
  std::vector<double> sum(x.size(), 0.0);
  for (int node = 0; node < graph.rows(); ++node) {
    for (std::size_t i = 0; i < graph.columns_of(node).size(); ++i) {
      sum[std::size_t(node)] += graph.weights_of(node)[i] *
                                (x[std::size_t(node)] - x[std::size_t(graph.columns_of(node)[i])]);
    }
  }
  return sum;
}

class AlgebraicMultigridTest : public testing::Test {
 protected:
  std::vector<double> cycle(const std::vector<double>& right) {
    std::copy(right.begin(), right.end(), multigrid_.right().begin());
    const auto& value = multigrid_.cycle();
    return {value.begin(), value.end()};
  }
  std::vector<double> drawn(Seed seed) const {
    std::vector<double> values(std::size_t(graph_.rows()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = gaussian(seed, int(i));
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
    for (double& value : values) value -= mean;
    return values;
  }

  // Weights from 1e-6 to 1; several levels.
  const SparseRows graph_ = lattice_graph(120, 130, [](int row, int col, bool down) {
    return float(std::pow(10.0, -6.0 * uniform(7, row, col, down)));
  });
  AlgebraicMultigrid multigrid_{graph_};
};

TEST_F(AlgebraicMultigridTest, LeavesLittleOfTheErrorWhateverTheWeights) {
  // In the norm of the energy; a tenth is what the conjugate gradients around it count on.
  const std::vector<double> x = drawn(1);
  const std::vector<double> found = cycle(image(graph_, x));
  std::vector<double> error = x;
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= found[i];
  EXPECT_LT(dot(error, image(graph_, error)), 0.1 * 0.1 * dot(x, image(graph_, x)));
}

TEST_F(AlgebraicMultigridTest, IsSymmetricAsConjugateGradientsWantIt) {
  const std::vector<double> a = image(graph_, drawn(2));
  const std::vector<double> b = image(graph_, drawn(3));
  const double ab = dot(a, cycle(b));
  const double ba = dot(b, cycle(a));
  // Weights of coarser levels are rounded to floats at both ends of an edge.
  EXPECT_NEAR(ab, ba, 1e-5 * std::sqrt(dot(a, cycle(a)) * dot(b, cycle(b))));
}

}  // namespace
}  // namespace hada
