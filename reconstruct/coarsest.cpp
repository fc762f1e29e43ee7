#include "reconstruct/coarsest.h"

#include "reconstruct/row_arithmetic.h"

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
    return row_kernels::count_positive(values.size(), values.data());
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
  std::vector<GraphEdge> edges;
  for_edges(level, [&](std::size_t from, std::size_t to, double weight) {
    if (weight != 0.0) edges.push_back({index[from], index[to], weight});
  });
  factors_.emplace(int(nodes_.size()), edges);
  values_.resize(Eigen::Index(nodes_.size()));
}

void CoarsestSolver::solve(PixelLevel& level) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    values_[Eigen::Index(i)] = level.right[std::size_t(nodes_[i])];
  }
  factors_->solve(values_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    level.value[std::size_t(nodes_[i])] = float(values_[Eigen::Index(i)]);
  }
}

}  // namespace hada
