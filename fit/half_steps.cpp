#include "fit/half_steps.h"

#include <algorithm>
#include <numbers>

namespace hada {
namespace {

constexpr int fewest = 256;  // squares along a side

/// exp(2 pi i f x) at the middles of squares, a row for each frequency.
Eigen::MatrixXcd waves(int pixels, int block, int most, double way) {
  const int squares = (pixels + block - 1) / block;
  Eigen::MatrixXcd table(2 * most + 1, squares);
  for (int i = 0; i < squares; ++i) {
    const double at = way * ((i + 0.5) * block / pixels - 0.5);
    for (int k = -most; k <= most; ++k)
      table(k + most, i) = std::polar(1.0, std::numbers::pi * k * at);
  }
  return table;
}

}  // namespace

HalfSteps::HalfSteps(const Grid<double>& map, int most) : most_(most) {
  const int block = std::max(std::min(map.rows(), map.cols()) / fewest, 1);
  const Eigen::MatrixXcd across = waves(map.cols(), block, most, 1.0);
  const Eigen::MatrixXcd up = waves(map.rows(), block, most, -1.0);  // rows run downward
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(across.cols(), up.cols());
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col) squares(col / block, row / block) += map(row, col);
  }
  sums_ = across * squares * up.transpose();
}

}  // namespace hada
