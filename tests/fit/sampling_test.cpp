#include "fit/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/surface.h"
#include "fit/whittle.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

Spectrum spectrum_of_size(const Extent& extent) {
  Grid<float> map(extent.rows, extent.cols);
  for (int i = 0; i < int(map.size()); ++i) map[std::size_t(i)] = float(gaussian(3, i));
  return power_spectrum(map, full_mask(extent), extent);
}

TEST(Sampling, ExpectsWhatASumOverAllPairsOfPixelsSays) {
  const Extent extent{20, 24, 0.5, Unit::mm};
  const auto spectrum = spectrum_of_size(extent);
  const Wrinkle<> wrinkle{.components = {{0.4, 1.3, 0.7, 0.6}}, .floor_mm4 = 1e-4};
  const auto expected = expected_power(wrinkle, taper_overlap(spectrum.taper), extent);
  const auto [variance, xx, xy, yy] = autocovariance(wrinkle.components[0]);
  double sum_w2 = 0.0;
  for (const double weight : spectrum.taper) sum_w2 += weight * weight;
  const int row = 18, col = 3;  // two steps upward, three to the right
  double sum = 0.0;
  for (int a = 0; a < 480; ++a) {
    for (int b = 0; b < 480; ++b) {
      const double dx = 0.5 * (a % 24 - b % 24), dy = -0.5 * (a / 24 - b / 24);
      const double covariance =
          variance * std::exp(-(xx * dx * dx + 2.0 * xy * dx * dy + yy * dy * dy));
      const double phase = 2.0 * pi * (spectrum.fx(col) * dx + spectrum.fy(row) * dy);
      sum += spectrum.taper[std::size_t(a)] * spectrum.taper[std::size_t(b)] * covariance *
             std::cos(phase);
    }
  }
  EXPECT_NEAR(expected(row, col) / (sum * 0.25 / sum_w2 + 1e-4), 1.0, 1e-9);  // rounding
}

TEST(Sampling, CorrectsCellsToTheirMeanExpectation) {
  const Extent extent{128, 128, 0.2, Unit::mm};
  const auto spectrum = spectrum_of_size(extent);
  const Wrinkle<> wrinkle{.components = {{0.4, 2.0, 1.0, 2.5}}, .floor_mm4 = 1e-6};
  const auto overlap = taper_overlap(spectrum.taper);
  const auto expected = expected_power(wrinkle, overlap, extent);
  const auto cells = corrected(cells_of(spectrum, leakage(spectrum)), wrinkle, overlap, extent);
  const auto model = densities(wrinkle, cells);
  int wide = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double sum = 0.0;
    for (const int ordinate : cells[i].ordinates) sum += expected(ordinate / 65, ordinate % 65);
    if (sum / cells[i].count < cells[i].leakage) continue;
    EXPECT_NEAR(model[i] / (sum / cells[i].count), 1.0, 1e-9);  // rounding
    wide += cells[i].count > 1;
    if (cells[i].count > 1) continue;
    const double side = cells[i].fx < 0.0 ? -1.0 : 1.0;
    const int row = int(std::lround(-side * cells[i].fy * extent.height()));
    const int col = int(std::lround(side * cells[i].fx * extent.width()));
    EXPECT_NEAR(sum / expected((row + 128) % 128, col), 1.0, 1e-9);  // f and -f
  }
  EXPECT_GT(wide, 100);
}

TEST(Sampling, TrustsNoCellNearNyquistThatAnAliasMayReach) {
  const Extent extent{128, 128, 1.0, Unit::px};
  auto cells = cells_of(spectrum_of_size(extent), leakage(spectrum_of_size(extent)));
  for (Cell& cell : cells) cell.leakage = 0.0;
  const auto farthest = [&](const Wrinkle<>& wrinkle) {
    double along_an_axis = 0.0;
    for (const Cell& cell : trusted(cells, wrinkle, extent))
      along_an_axis = std::max({along_an_axis, std::abs(cell.fx), std::abs(cell.fy)});
    return along_an_axis;
  };
  // Amplitudes fall as exp(-2 pi^2 s^2 f^2): 2 exp(-2 pi^2 s^2 (1 - 2 f)) passes 0.5 % at f = 0.348
  // for a kernel of a pixel; a cell is 6 % wide. A floor that outshines the alias makes it
  // harmless.
  EXPECT_NEAR(farthest({.components = {{0.1, 1.0, 1.0, 0.0}}}), 0.348, 0.03);
  EXPECT_GT(farthest({.components = {{0.1, 3.0, 3.0, 0.0}}, .floor_mm4 = 1e-4}), 0.47);
}

TEST(Sampling, DoesNotAskTheCellItselfWhetherToTrustIt) {
  const Extent extent{64, 64, 1.0, Unit::px};
  auto cells = cells_of(spectrum_of_size(extent), leakage(spectrum_of_size(extent)));
  const Wrinkle<> wrinkle{.components = {{0.1, 3.0, 2.0, 0.0}}, .floor_mm4 = 1e-3};
  const auto before = trusted(cells, wrinkle, extent).size();
  for (Cell& cell : cells) cell.power *= 1e-6;
  EXPECT_EQ(trusted(cells, wrinkle, extent).size(), before);
}

}  // namespace
}  // namespace hada
