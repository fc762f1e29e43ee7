#pragma once

#include <complex>

#include <Eigen/Core>

#include "core/grid.h"

namespace hada {

/// Sums of a map times exp(2 pi i (fx x + fy y)), x and y from its middle and y up, at frequencies
/// of whole halves of the step between the ordinates of its transform.
///
/// Only slow waves are asked for: of a large map, squares of pixels are added up first, of which
/// 256 or more are left along each side. That changes a sum at 14 steps by 0.5 %.
class HalfSteps {
 public:
  /// most  half steps up to which sums are known, along x and y, forwards and backwards
  HalfSteps(const Grid<double>& map, int most);

  /// The sum at (half_x, half_y) half steps.
  std::complex<double> at(int half_x, int half_y) const {
    return sums_(half_x + most_, half_y + most_);
  }

 private:
  int most_;
  Eigen::MatrixXcd sums_;
};

}  // namespace hada
