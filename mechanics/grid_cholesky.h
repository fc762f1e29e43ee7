#pragma once

#include <vector>

#include <Eigen/Core>

namespace hada {

/// A symmetric matrix that couples each point of a grid with its four neighbours: blocks of
/// `block` x `block`, side by side in the order of the points, row after row.
struct GridMatrix {
  int rows = 0;
  int cols = 0;
  bool round = false;  // the last column is a neighbour of the first
  int block = 1;
  Eigen::MatrixXd own;    // of each point with itself, symmetric
  Eigen::MatrixXd right;  // row: the point; column: its neighbour in the next column
  Eigen::MatrixXd up;     // and in the next row

  GridMatrix(int rows, int cols, bool round, int block);
  auto at(Eigen::MatrixXd& blocks, int point) { return blocks.middleCols(block * point, block); }
};

/// The Cholesky factors of a positive definite GridMatrix, by nested dissection: the grid is halved
/// by lines of points again and again, and lines are eliminated last, in dense fronts.
///
/// Work grows as the cube of a side, memory as the square times its logarithm.
/// (In floats the smoothest modes of 300 x 300 lose three digits, and an iteration that it
/// preconditions takes ten times as long.)
///
/// Source: George, Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10
/// (1973); Duff and Reid, The multifrontal solution, ACM TOMS 9 (1983).
class GridCholesky {
 public:
  GridCholesky(int rows, int cols, bool round);

  /// throws  Error if the matrix is not positive definite
  void factorize(const GridMatrix& matrix);
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

 private:
  // Points [0, eliminated) of `points` go; the others are of lines that are eliminated later.
  struct Front {
    std::vector<int> points;
    int eliminated = 0;
    std::vector<int> children;
    Eigen::MatrixXd lower;  // L of the eliminated points, above what it does to the others
    Eigen::MatrixXd rest;   // what is left of the front for its parent
  };
  struct Part {
    int row = 0, rows = 0, col = 0, cols = 0;
  };

  int dissect(const Part& part, int depth);
  void eliminate(Front& front, const GridMatrix& matrix) const;

  int rows_, cols_;
  bool round_;
  int block_ = 1;
  std::vector<Front> fronts_;             // children before parents
  std::vector<std::vector<int>> levels_;  // fronts by their depth
};

}  // namespace hada
