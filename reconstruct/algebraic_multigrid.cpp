#include "reconstruct/algebraic_multigrid.h"

#include <algorithm>
#include <utility>

#include "reconstruct/coarse_nodes.h"
#include "reconstruct/interpolation.h"

namespace hada {
namespace {

constexpr int coarsest_nodes = 1500;  // factorised in a few milliseconds

}  // namespace

AlgebraicMultigrid::Level::Level(SparseRows level_graph)
    : graph(std::move(level_graph)),
      inverse(std::size_t(graph.rows()), 0.0, graph.memory()),
      value(inverse),
      right(inverse) {
  for (int node = 0; node < graph.rows(); ++node) {
    double sum = 0.0;
    for (const float weight : graph.weights_of(node)) sum += weight;
    inverse[std::size_t(node)] = sum > 0.0 ? 1.0 / sum : 0.0;
  }
}

AlgebraicMultigrid::AlgebraicMultigrid(SparseRows graph) {
  levels_.emplace_back(std::move(graph));
  while (levels_.back().graph.rows() > coarsest_nodes) {
    Level& level = levels_.back();
    SparseRows carried = hada::interpolation(level.graph, coarse_nodes(level.graph));
    if (carried.columns > 0.9 * level.graph.rows()) break;
    SparseRows coarse = coarse_graph(level.graph, carried);
    level.interpolation = std::move(carried);
    levels_.emplace_back(std::move(coarse));
  }
  const SparseRows& last = levels_.back().graph;
  std::vector<GraphEdge> edges;
  for (int node = 0; node < last.rows(); ++node) {
    const auto columns = last.columns_of(node);
    const auto weights = last.weights_of(node);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      edges.push_back({node, columns[i], 0.5 * weights[i]});  // listed at both ends
    }
  }
  coarsest_.emplace(last.rows(), edges);
}

void AlgebraicMultigrid::relax(Level& level, bool forwards) {
  const int count = level.graph.rows();
  for (int i = 0; i < count; ++i) {
    const int node = forwards ? i : count - 1 - i;
    const auto columns = level.graph.columns_of(node);
    const auto weights = level.graph.weights_of(node);
    double sum = level.right[std::size_t(node)];
    for (std::size_t j = 0; j < columns.size(); ++j) {
      sum += weights[j] * level.value[std::size_t(columns[j])];
    }
    level.value[std::size_t(node)] = sum * level.inverse[std::size_t(node)];
  }
}

// The right-hand side of the coarser level: what is left on this one.
void AlgebraicMultigrid::restrict_rest(const Level& level, Level& coarse) {
  std::fill(coarse.right.begin(), coarse.right.end(), 0.0);
  for (int node = 0; node < level.graph.rows(); ++node) {
    const double here = level.value[std::size_t(node)];
    const auto columns = level.graph.columns_of(node);
    const auto weights = level.graph.weights_of(node);
    double rest = level.right[std::size_t(node)];
    for (std::size_t j = 0; j < columns.size(); ++j) {
      rest += weights[j] * (level.value[std::size_t(columns[j])] - here);
    }
    const auto to = level.interpolation.columns_of(node);
    const auto shares = level.interpolation.weights_of(node);
    for (std::size_t j = 0; j < to.size(); ++j) {
      coarse.right[std::size_t(to[j])] += shares[j] * rest;
    }
  }
}

void AlgebraicMultigrid::visit(std::size_t index) {
  Level& level = levels_[index];
  if (index + 1 == levels_.size()) {
    Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(level.right.data(), Eigen::Index(level.right.size()));
    coarsest_->solve(values);
    std::copy(values.begin(), values.end(), level.value.begin());
    return;
  }
  Level& coarse = levels_[index + 1];
  const int visits = index + 2 == levels_.size() ? 1 : 2;
  std::fill(level.value.begin(), level.value.end(), 0.0);
  for (int i = 0; i < visits; ++i) {
    relax(level, true);
    restrict_rest(level, coarse);
    visit(index + 1);
    for (int node = 0; node < level.graph.rows(); ++node) {
      const auto from = level.interpolation.columns_of(node);
      const auto shares = level.interpolation.weights_of(node);
      double& value = level.value[std::size_t(node)];
      for (std::size_t j = 0; j < from.size(); ++j) {
        value += shares[j] * coarse.value[std::size_t(from[j])];
      }
    }
    relax(level, false);
  }
}

const AlgebraicMultigrid::Values& AlgebraicMultigrid::cycle() {
  visit(0);
  return levels_.front().value;
}

}  // namespace hada
