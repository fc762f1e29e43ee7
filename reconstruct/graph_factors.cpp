#include "reconstruct/graph_factors.h"

#include <algorithm>
#include <numeric>

namespace hada {

GraphFactors::GraphFactors(int nodes, const std::vector<GraphEdge>& edges)
    : region_(std::size_t(nodes)), count_(std::size_t(nodes), 0.0) {
  std::iota(region_.begin(), region_.end(), 0);
  const auto region_of = [&](int i) {
    while (region_[std::size_t(i)] != i)
      i = region_[std::size_t(i)] = region_[std::size_t(region_[std::size_t(i)])];
    return i;
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b, weight] : edges) {
    if (weight == 0.0) continue;
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    const auto [low, high] = std::minmax({region_of(a), region_of(b)});
    region_[std::size_t(high)] = low;
  }
  // One node of each region is tied to 0, which takes nothing from a right-hand side of zero sum.
  for (int i = 0; i < nodes; ++i) {
    if (region_of(i) == i) entries.emplace_back(i, i, 1.0);
  }
  Eigen::SparseMatrix<double> matrix(nodes, nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (nodes > 0) factors_.compute(matrix);
  for (int i = 0; i < nodes; ++i) region_[std::size_t(i)] = region_of(i);
  for (const int region : region_) count_[std::size_t(region)] += 1.0;
}

void GraphFactors::solve(Eigen::VectorXd& values) const {
  if (region_.empty()) return;
  values = factors_.solve(values).eval();
  std::vector<double> mean(region_.size(), 0.0);  // of the region that begins at a node
  for (std::size_t i = 0; i < region_.size(); ++i) {
    const auto region = std::size_t(region_[i]);
    mean[region] += values[Eigen::Index(i)] / count_[region];
  }
  for (std::size_t i = 0; i < region_.size(); ++i) {
    values[Eigen::Index(i)] -= mean[std::size_t(region_[i])];
  }
}

}  // namespace hada
