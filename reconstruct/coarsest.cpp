#include "reconstruct/coarsest.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hada {
namespace {

bool is_held(const PixelLevel& level, std::size_t node) {
  if (!level.unit()) return level.inverse[node] > 0.0f;
  return level.code[node] != 0;
}

// work(a, b, weight) for every edge; those between two extra nodes come twice, with half the
// weight.
template <class Work>
void for_edges(const PixelLevel& level, const Work& work) {
  const Dealt& at = level.at;
  const auto weight = [&](const Cells& weights, std::size_t a, std::size_t b) {
    if (!level.unit()) return double(weights[a]);
    return level.code[a] && level.code[b] ? 1.0 : 0.0;
  };
  for (int row = 0; row < at.rows; ++row) {
    for (int col = 0; col < at.cols; ++col) {
      const auto cell = std::size_t(at.cell(row, col));
      const auto beyond = std::size_t(at.cell(row, col + 1));
      const auto below = cell + std::size_t(at.stride());
      if (col + 1 < at.cols) work(cell, beyond, weight(level.east, cell, beyond));
      if (row + 1 < at.rows) work(cell, below, weight(level.south, cell, below));
    }
  }
  for (std::size_t i = 0; i < level.extras.size(); ++i) {
    for (int e = level.extras[i].first_edge; e < level.last_edge(i); ++e) {
      const auto& edge = level.edges[std::size_t(e)];
      work(level.at.size() + i, std::size_t(edge.to),
           (level.is_extra(edge.to) ? 0.5 : 1.0) * double(edge.weight));
    }
  }
}

}  // namespace

std::size_t CoarsestSolver::size_of(const PixelLevel& level) {
  const auto count = [](const auto& values) {
    return std::size_t(
        std::count_if(values.begin(), values.end(), [](auto value) { return value > 0; }));
  };
  return level.unit() ? count(level.code) : count(level.inverse);
}

CoarsestSolver::CoarsestSolver(const PixelLevel& level) {
  std::vector<int> index(level.nodes(), -1);
  for (std::size_t node = 0; node < level.nodes(); ++node) {
    if (!is_held(level, node)) continue;
    index[node] = int(nodes_.size());
    nodes_.push_back(PixelLevel::Node(node));
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int>& region = region_;
  region.resize(nodes_.size());
  std::iota(region.begin(), region.end(), 0);
  const auto region_of = [&](int i) {
    while (region[std::size_t(i)] != i)
      i = region[std::size_t(i)] = region[std::size_t(region[std::size_t(i)])];
    return i;
  };
  for_edges(level, [&](std::size_t from, std::size_t to, double weight) {
    if (weight == 0.0) return;
    const int a = index[from];
    const int b = index[to];
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    const auto [low, high] = std::minmax({region_of(a), region_of(b)});
    region[std::size_t(high)] = low;
  });
  // One node of each region is tied to 0, which takes nothing from a right-hand side of zero sum.
  for (int i = 0; i < int(nodes_.size()); ++i) {
    if (region_of(i) == i) entries.emplace_back(i, i, 1.0);
  }
  Eigen::SparseMatrix<double> matrix(int(nodes_.size()), int(nodes_.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!nodes_.empty()) factors_.compute(matrix);
  for (int i = 0; i < int(nodes_.size()); ++i) region[std::size_t(i)] = region_of(i);
  count_.assign(nodes_.size(), 0.0);
  for (const int r : region) count_[std::size_t(r)] += 1.0;
  right_.resize(int(nodes_.size()));
}

void CoarsestSolver::solve(PixelLevel& level) {
  if (nodes_.empty()) return;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    right_[Eigen::Index(i)] = level.right[std::size_t(nodes_[i])];
  }
  const Eigen::VectorXd value = factors_.solve(right_);
  std::vector<double> mean(nodes_.size(), 0.0);  // of the region that begins at a node
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto region = std::size_t(region_[i]);
    mean[region] += value[Eigen::Index(i)] / count_[region];
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double levelled = value[Eigen::Index(i)] - mean[std::size_t(region_[i])];
    level.value[std::size_t(nodes_[i])] = float(levelled);
  }
}

}  // namespace hada
