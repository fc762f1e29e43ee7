#include "fit/cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/surface.h"

namespace hada {
namespace {

Spectrum white(const Extent& extent) {
  Grid<float> map(extent.rows, extent.cols);
  for (int i = 0; i < int(map.size()); ++i) map[std::size_t(i)] = float(gaussian(1, i));
  return power_spectrum(map, full_mask(extent), extent);
}

TEST(Cells, HoldEveryOrdinateOfTheHalfPlaneOnce) {
  const auto spectrum = white({96, 80, 0.5, Unit::mm});
  int inside = 0;
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 80; ++col) {
      if (row + col > 0 && std::hypot(spectrum.fx(col), spectrum.fy(row)) < 1.0) ++inside;
    }
  }
  int count = 0;
  for (const Cell& cell : cells_of(spectrum, leakage(spectrum))) count += cell.count;
  EXPECT_EQ(2 * count, inside);
}

TEST(Cells, AreSingleOrdinatesNearZeroAndGrowFurtherOut) {
  const auto spectrum = white({128, 128, 1.0, Unit::px});
  for (const Cell& cell : cells_of(spectrum, leakage(spectrum))) {
    const double steps = std::hypot(cell.fx, cell.fy) * 128.0;
    EXPECT_TRUE(steps >= 16.0 || cell.count == 1);
  }
  int largest = 0;
  for (const Cell& cell : cells_of(spectrum, leakage(spectrum))) {
    largest = std::max(largest, cell.count);
  }
  EXPECT_GT(largest, 4);
}

TEST(Cells, AreSquaresWherePatchesAreAskedFor) {
  const auto spectrum = white({128, 96, 1.0, Unit::px});
  const auto cells =
      cells_of(spectrum, leakage(spectrum), {.inner_bins = 4.0, .patch = 4, .most_leakage = 1.0});
  for (const Cell& cell : cells) EXPECT_LE(cell.count, 16);
  const auto whole =
      std::count_if(cells.begin(), cells.end(), [](const Cell& cell) { return cell.count == 16; });
  // Most of the half disc of pi / 2 (48 / 96)^2 of 128 x 96 ordinates, but for its edges.
  EXPECT_GT(double(whole), 0.8 * std::numbers::pi / 8.0 * 128 * 96 / 16.0);
}

TEST(Cells, NarrowAnAutocovarianceAsAveragingOverThemDoes) {
  // For a Gaussian spectrum exp(-a f^2), compare the mean over the ordinates of a ring-shaped
  // region with the formula, cell by cell: they differ in the fourth order of the cell's size.
  auto spectrum = white({256, 256, 1.0, Unit::px});
  const double length = 3.0;
  const double pi = std::numbers::pi;
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 256; ++col) {
      const double f = std::hypot(spectrum.fx(col), spectrum.fy(row));
      spectrum.power(row, col) = std::exp(-4.0 * pi * pi * length * length * f * f);
    }
  }
  spectrum.window_x = spectrum.window_y = 0.0;
  const double p = 0.25 / (length * length);
  for (const Cell& cell : cells_of(spectrum, leakage(spectrum), {.faintest = 1e-6})) {
    const double xx = p + cell.xx, xy = cell.xy, yy = p + cell.yy;
    const double det = xx * yy - xy * xy;
    const double q = (yy * cell.fx * cell.fx - 2 * xy * cell.fx * cell.fy + xx * cell.fy * cell.fy);
    const double expected = p / std::sqrt(det) * std::exp(-pi * pi * q / det);
    // A cell spans up to 0.06 r; at r = 3.7 deviations (where 1e-6 ends) that is a = 0.8 in the
    // exponent: (a / 2)^4 / 120 of a uniform cell against a Gaussian one, and little cells of an
    // irregular shape.
    EXPECT_NEAR(cell.power / expected, 1.0, 0.01);
  }
}

TEST(Cells, LeaveOutWhatLevellingEmptied) {
  const auto spectrum = white({64, 64, 1.0, Unit::px});
  const auto leaked = leakage(spectrum);
  // One step from 0 lie (1, 0), (0, 1), (1, 1), (1, -1) of the half plane.
  EXPECT_EQ(cells_of(spectrum, leaked, {.empty_steps = 0.5}).size(),
            cells_of(spectrum, leaked, {.empty_steps = 1.5}).size() + 4);
}

}  // namespace
}  // namespace hada
