#include "reconstruct/multigrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/regions.h"
#include "scenes.h"

namespace hada {
namespace {

// A right-hand side of zero sum in every region: what the Laplacian can be inverted on.
Grid<double> balanced(const Mask& mask, Seed seed) {
  const Regions regions = regions_of(mask);
  std::vector<double> sum(regions.size.size(), 0.0);
  Grid<double> values(mask.rows(), mask.cols());
  for (const int pass : {0, 1}) {
    for (int row = 0; row < mask.rows(); ++row) {
      for (int col = 0; col < mask.cols(); ++col) {
        const auto region = std::size_t(regions.label(row, col));
        if (pass == 0) sum[region] += gaussian(seed, row, col);
        if (pass == 0 || region == 0) continue;
        values(row, col) = gaussian(seed, row, col) - sum[region] / regions.size[region];
      }
    }
  }
  return values;
}

// The largest |right - A x|, in double precision.
double largest_residual(const Mask& mask, const Grid<double>& right, const Grid<float>& value) {
  Grid<double> rest = right;
  const auto pull = [&](int row, int col, int r, int c) {
    if (!mask(row, col) || !mask.contains(r, c) || !mask(r, c)) return;
    const double flow = double(value(r, c)) - value(row, col);
    rest(row, col) += flow;
    rest(r, c) -= flow;
  };
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      pull(row, col, row, col + 1);
      pull(row, col, row + 1, col);
    }
  }
  double most = 0.0;
  for (const double value_left : rest) most = std::max(most, std::abs(value_left));
  return most;
}

void set_right(Multigrid& multigrid, const Grid<double>& right) {
  for (int row = 0; row < right.rows(); ++row) {
    for (int col = 0; col < right.cols(); ++col) {
      multigrid.right()[std::size_t(multigrid.finest().at.cell(row, col))] = float(right(row, col));
    }
  }
}

TEST(Multigrid, SolvesTheLaplacianOfATornMask) {
  for (const int size : {20, 150}) {  // one level, and several
    const Mask mask = torn_mask(size, size + 17, 2);
    Multigrid multigrid(PixelLevel::of(mask));
    const Grid<double> right = balanced(mask, 11);
    set_right(multigrid, right);
    const auto solution = multigrid.solve(1e-6, 100);
    double most = 0.0;
    for (const float x : solution.value) most = std::max(most, double(std::abs(x)));
    // The last sweep rounds: a sum of four values to 4 * 6e-8 of one, which is a quarter of that in
    // the value, and the value to 6e-8 of itself twice; at both ends of 4 edges that is less than
    // four roundings each.
    EXPECT_LT(largest_residual(mask, right, solution.value), 4 * 8 * 6e-8 * most + 1e-5);
  }
}

}  // namespace
}  // namespace hada
