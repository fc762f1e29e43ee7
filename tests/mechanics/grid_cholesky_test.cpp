#include "mechanics/grid_cholesky.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace hada {
namespace {

using Eigen::MatrixXd;

// A random matrix that is positive definite because its diagonal outweighs the rest.
GridMatrix random_matrix(int rows, int cols, bool round, int block) {
  GridMatrix matrix(rows, cols, round, block);
  for (Eigen::Index i = 0; i < matrix.right.size(); ++i) {
    matrix.right(i) = gaussian(3, i, 0), matrix.up(i) = gaussian(3, i, 1);
  }
  for (int i = 0; i < rows * cols; ++i) {
    matrix.at(matrix.own, i) = 10.0 * block * MatrixXd::Identity(block, block);
  }
  return matrix;
}

MatrixXd dense(GridMatrix matrix) {
  const int b = matrix.block, n = matrix.rows * matrix.cols;
  MatrixXd full = MatrixXd::Zero(b * n, b * n);
  for (int i = 0; i < n; ++i) {
    const int col = i % matrix.cols;
    full.block(b * i, b * i, b, b) = matrix.at(matrix.own, i);
    const auto couple = [&](int j, const MatrixXd& value) {
      full.block(b * i, b * j, b, b) += value;
      full.block(b * j, b * i, b, b) += value.transpose();
    };
    if (col + 1 < matrix.cols) couple(i + 1, matrix.at(matrix.right, i));
    if (col + 1 == matrix.cols && matrix.round) couple(i - col, matrix.at(matrix.right, i));
    if (i + matrix.cols < n) couple(i + matrix.cols, matrix.at(matrix.up, i));
  }
  return full;
}

TEST(GridCholesky, SolvesWhatADenseMatrixSays) {
  for (const bool round : {false, true}) {
    for (const auto& [rows, cols] : {std::pair{2, 3}, {7, 9}, {13, 6}, {9, 17}}) {
      for (const int block : {1, 2, 3}) {
        const GridMatrix matrix = random_matrix(rows, cols, round, block);
        GridCholesky factors(rows, cols, round);
        factors.factorize(matrix);
        Eigen::VectorXd b(block * rows * cols);
        for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = gaussian(4, i);
        EXPECT_LT((dense(matrix) * factors.solve(b) - b).norm(), 1e-12 * b.norm());
      }
    }
  }
}

TEST(GridCholesky, GivesTheSameBytesAtAnyNumberOfThreads) {
  const GridMatrix matrix = random_matrix(30, 40, true, 2);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(2400, -1.0, 1.0);
  std::vector<Eigen::VectorXd> solved;
  for (const int count : {1, 3}) {
    set_threads(count);
    GridCholesky factors(30, 40, true);
    factors.factorize(matrix);
    solved.push_back(factors.solve(b));
  }
  set_threads(0);
  EXPECT_EQ(solved[0], solved[1]);
}

TEST(GridCholesky, RefusesAGridThatMovesFreely) {
  GridMatrix matrix = random_matrix(8, 8, false, 1);
  matrix.own.setConstant(-1.0);
  GridCholesky factors(8, 8, false);
  EXPECT_THROW(factors.factorize(matrix), Error);
}

}  // namespace
}  // namespace hada
