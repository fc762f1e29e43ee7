#include "fit/half_steps.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// exp(-|x|^2 / (2 deviation^2)) about a place in steps of the side, y up.
Grid<double> hill(int rows, int cols, double at_x, double at_y, double deviation) {
  Grid<double> map(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double x = (col + 0.5) / cols - 0.5 - at_x, y = 0.5 - (row + 0.5) / rows - at_y;
      map(row, col) = std::exp(-0.5 * (x * x + y * y) / (deviation * deviation));
    }
  }
  return map;
}

TEST(HalfSteps, AreTheTransformOfAHill) {
  constexpr double deviation = 0.04, x = 0.1, y = -0.2;
  for (const auto& [rows, cols] : {std::pair{64, 90}, {523, 611}}) {
    const HalfSteps sums(hill(rows, cols, x, y, deviation), 28);
    const double whole = 2.0 * pi * deviation * deviation * rows * cols;
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {-3, 2}, {0, -7}, {28, -5}}) {
      const double fx = 0.5 * a, fy = 0.5 * b;
      const double size = std::exp(-2.0 * std::pow(pi * deviation, 2) * (fx * fx + fy * fy));
      const auto wanted = std::polar(whole * size, 2.0 * pi * (fx * x + fy * y));
      // Squares of 2 pixels of 523 turn the phase of 14 steps by pi 14 / 523 to either side: the
      // mean over them is short by its square / 2 = 0.4 %.
      EXPECT_LT(std::abs(sums.at(a, b) - wanted), 0.004 * whole * size + 1e-9 * whole)
          << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace hada
