#pragma once

#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace hada {

struct GraphEdge {
  int a;
  int b;
  double weight;
};

/// The Laplacian of a graph, factorised in double precision.
class GraphFactors {
 public:
  /// The same edge may be listed more than once: its weights add up.
  GraphFactors(int nodes, const std::vector<GraphEdge>& edges);

  /// x with A x = values, of zero mean over the nodes of each region; `values` sum to 0 there.
  void solve(Eigen::VectorXd& values) const;

 private:
  std::vector<int> region_;    // of a node: the first of its region
  std::vector<double> count_;  // of nodes in the region that begins at a node
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace hada
