#include "reconstruct/interpolation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "reconstruct/coarse_nodes.h"

namespace hada {
namespace {

constexpr std::size_t most_shares = 4;

// Sums by column of one row at a time.
class RowSums {
 public:
  explicit RowSums(int columns) : row_(std::size_t(columns), -1), sum_(std::size_t(columns), 0.0) {}

  void begin(int row) {
    at_ = row;
    columns_.clear();
  }
  bool has(int column) const { return row_[std::size_t(column)] == at_; }
  void add(int column, double value) {
    if (!has(column)) {
      row_[std::size_t(column)] = at_;
      sum_[std::size_t(column)] = 0.0;
      columns_.push_back(column);
    }
    sum_[std::size_t(column)] += value;
  }
  double operator[](int column) const { return sum_[std::size_t(column)]; }
  std::vector<int>& columns() { return columns_; }

 private:
  int at_ = -1;
  std::vector<int> row_;  // that a column was last met in
  std::vector<double> sum_;
  std::vector<int> columns_;
};

// Rounds the shares so that they add up to 1 exactly: else a plate that hangs on weak edges would
// pull at its neighbours.
void round_shares(std::vector<double>& shares) {
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  double rest = 1.0;
  for (double& share : shares) rest -= share = std::floor(share / sum * 0x1p24) * 0x1p-24;
  *std::max_element(shares.begin(), shares.end()) += rest;
}

class Interpolator {
 public:
  Interpolator(const SparseRows& graph, const std::vector<std::uint8_t>& coarse)
      : graph_(graph), coarse_(coarse), heaviest_(heaviest_edges(graph)), pull_(graph.rows()) {}

  SparseRows run() {
    std::vector<int> number(std::size_t(graph_.rows()), 0);
    int count = 0;
    for (int node = 0; node < graph_.rows(); ++node) {
      number[std::size_t(node)] = count;
      count += is_coarse(node);
    }
    SparseRows result(count, graph_.memory());
    std::vector<double> shares;
    for (int node = 0; node < graph_.rows(); ++node) {
      if (is_coarse(node)) {
        result.add(number[std::size_t(node)], 1.0f);
      } else if (heaviest_[std::size_t(node)] > 0.0f) {
        find_pulls(node);
        const std::vector<int>& kept = largest_pulls();
        if (kept.empty()) {  // nothing that it depends on is coarse: sweeps must do
          result.end_row();
          continue;
        }
        shares.clear();
        for (const int other : kept) shares.push_back(pull_[other]);
        round_shares(shares);
        for (std::size_t i = 0; i < kept.size(); ++i) {
          if (shares[i] > 0.0) result.add(number[std::size_t(kept[i])], float(shares[i]));
        }
      }
      result.end_row();
    }
    return result;
  }

 private:
  bool is_coarse(int node) const { return coarse_[std::size_t(node)] != 0; }
  bool depends(int node, float weight) const {
    return is_strong(weight, heaviest_[std::size_t(node)]);
  }
  template <class Work>
  void for_edges(int node, const Work& work) const {
    const auto columns = graph_.columns_of(node);
    const auto weights = graph_.weights_of(node);
    for (std::size_t i = 0; i < columns.size(); ++i) work(columns[i], weights[i]);
  }

  // What pulls at the node, from the coarse nodes that it depends on, and from those that the fine
  // nodes depend on that it depends on; weak edges are taken to end at the node itself.
  void find_pulls(int node) {
    pull_.begin(node);
    for_edges(node, [&](int other, float weight) {
      if (!depends(node, weight)) return;
      if (is_coarse(other)) return pull_.add(other, 0.0);
      for_edges(other, [&](int third, float w) {
        if (is_coarse(third) && depends(other, w)) pull_.add(third, 0.0);
      });
    });
    for_edges(node, [&](int other, float weight) {
      if (pull_.has(other)) return pull_.add(other, weight);
      if (is_coarse(other) || !depends(node, weight)) return;
      double sum = 0.0;
      for_edges(other, [&](int third, float w) {
        if (w > 0.0f && (third == node || pull_.has(third))) sum += w;
      });
      for_edges(other, [&](int third, float w) {
        if (w > 0.0f && pull_.has(third)) pull_.add(third, double(weight) * w / sum);
      });
    });
  }

  // In the order of the nodes.
  const std::vector<int>& largest_pulls() {
    std::vector<int>& nodes = pull_.columns();
    nodes.erase(std::remove_if(nodes.begin(), nodes.end(), [&](int n) { return pull_[n] <= 0.0; }),
                nodes.end());
    std::sort(nodes.begin(), nodes.end(),
              [&](int a, int b) { return std::pair(-pull_[a], a) < std::pair(-pull_[b], b); });
    if (nodes.size() > most_shares) nodes.resize(most_shares);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  const SparseRows& graph_;
  const std::vector<std::uint8_t>& coarse_;
  std::vector<float> heaviest_;
  RowSums pull_;
};

}  // namespace

SparseRows interpolation(const SparseRows& graph, const std::vector<std::uint8_t>& coarse) {
  return Interpolator(graph, coarse).run();
}

SparseRows coarse_graph(const SparseRows& graph, const SparseRows& interpolation) {
  const SparseRows members = transposed(interpolation);
  SparseRows result(members.rows(), graph.memory());
  RowSums sums(members.rows());
  for (int coarse = 0; coarse < members.rows(); ++coarse) {
    sums.begin(coarse);
    const auto add = [&](int node, double factor) {
      const auto columns = interpolation.columns_of(node);
      const auto weights = interpolation.weights_of(node);
      for (std::size_t i = 0; i < columns.size(); ++i) sums.add(columns[i], factor * weights[i]);
    };
    const auto nodes = members.columns_of(coarse);
    const auto shares = members.weights_of(coarse);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto others = graph.columns_of(nodes[i]);
      const auto weights = graph.weights_of(nodes[i]);
      double held = 0.0;
      for (std::size_t j = 0; j < others.size(); ++j) {
        held += weights[j];
        add(others[j], double(shares[i]) * weights[j]);
      }
      add(nodes[i], -double(shares[i]) * held);
    }
    std::vector<int>& columns = sums.columns();
    std::sort(columns.begin(), columns.end());
    for (const int column : columns) {
      if (column != coarse && sums[column] != 0.0) result.add(column, float(sums[column]));
    }
    result.end_row();
  }
  return result;
}

}  // namespace hada
