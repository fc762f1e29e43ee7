#include "fit/slow_waves.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "fit/observe.h"
#include "fit/solve.h"
#include "fit/whittle.h"
#include "fit/wrinkle.h"
#include "fit/wrinkle_refine.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

Cell slow_cell(double steps_x, double steps_y, const Extent& extent) {
  return {.fx = steps_x / extent.width(), .fy = steps_y / extent.height(), .count = 1};
}

TEST(SlowWaves, KnowsWhatAPlaneTakesOfWhiteNoise) {
  const Extent extent{.rows = 96, .cols = 64, .pitch = 0.5, .unit = Unit::mm};
  const auto spectrum =
      power_spectrum(Grid<float>(96, 64), full_mask(extent), extent, {.taper = 0});
  Wrinkle<> white;
  white.components.clear();
  white.floor_mm4 = 1.0;
  const std::vector<Cell> cells{slow_cell(1, 0, extent), slow_cell(0, 1, extent),
                                slow_cell(1, 1, extent), slow_cell(2, 0, extent),
                                slow_cell(9, 0, extent)};
  // 12 |integral of x exp(2 pi i k x) over a unit|^2 = 3 / (pi k)^2 of a wave along an axis. Waves
  // beyond 14 steps are left out, which hold 1 / (pi^2 13) = 0.8 % on each side.
  const double one = 3.0 / (pi * pi);
  const double left[] = {1.0 - one, 1.0 - one, 1.0, 1.0 - one / 4.0, 1.0};
  const auto levelled = SlowWaves(spectrum, "plane").levelled(cells, white);
  const auto centred = SlowWaves(spectrum, "offset").levelled(cells, white);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_NEAR(levelled[i].correction, left[i], 0.016) << i;
    EXPECT_NEAR(centred[i].correction, 1.0, 0.016) << i;
  }
}

void take_off_plane(Grid<float>& map) {
  double sum = 0.0, along = 0.0, down = 0.0, squares = 0.0;
  const double middle = 0.5 * (map.rows() - 1);  // of a square
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col) {
      sum += map(row, col);
      along += (col - middle) * map(row, col);
      down += (row - middle) * map(row, col);
      squares += (col - middle) * (col - middle);
    }
  }
  const double mean = sum / double(map.size());
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col) {
      map(row, col) -=
          float(mean + along / squares * (col - middle) + down / squares * (row - middle));
    }
  }
}

/// A cut from a larger field with noise, levelled by a plane, 64 x 64 pixels.
Surface levelled_sheet(const Wrinkle<>& truth, Seed seed) {
  const auto field = synthesize(truth, {192, 192, 0.2, Unit::mm}, seed).height;
  Surface sheet;
  sheet.extent = {64, 64, 0.2, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = crop(field, 64, 64, 64, 64);
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col)
      sheet.height(row, col) += float(0.01 * gaussian(seed, row, col));
  }
  take_off_plane(sheet.height);
  sheet.levelling = "plane";
  return sheet;
}

TEST(SlowWaves, SayHowFarEstimatesScatter) {
  // Long and short axis are a twelfth and a 25th of the map.
  const Wrinkle<> truth{.components = {{0.3, 1.05, 0.5, 0.4}}};
  constexpr int sheets = 100;
  std::array<double, 3> squares{};
  for (int k = 0; k < sheets; ++k) {
    const auto fit = fit_wrinkle(levelled_sheet(truth, Seed(700 + k)), {.components = 1});
    const auto &found = fit.material.components[0], &sigma = fit.sigma.components[0];
    const auto add = [&](int i, double value, double wanted, double deviation) {
      squares[std::size_t(i)] += std::pow(std::log(value / wanted) * value / deviation, 2) / sheets;
    };
    add(0, found.amplitude_mm, 0.3, sigma.amplitude_mm);
    add(1, found.long_mm, 1.05, sigma.long_mm);
    add(2, found.short_mm, 0.5, sigma.short_mm);
  }
  // Of 100 the root mean square is known to 7 %; three times that.
  for (const double square : squares) EXPECT_NEAR(std::sqrt(square), 1.0, 0.21);
}

TEST(SlowWaves, LeavesShortWavesAlone) {
  const Wrinkle<> truth{.components = {{0.3, 0.3, 0.2, 0.4}}};
  const auto seen = observe(levelled_sheet(truth, 3));
  Fit<Wrinkle<>> fit;
  fit.material = truth;
  fit.cost = HUGE_VAL;
  const SlowWaves slow(seen.spectrum, seen.levelling);
  const auto cells = refine(fit, seen, slow).cells;
  const double kappa = seen.spectrum.independence;
  const auto jacobian =
      jacobian_of(fit.material, int(cells.size()), whitened_logarithms(cells, kappa));
  const Eigen::MatrixXd alone = jacobian.transpose() * jacobian;
  const auto known = slow.information(cells, fit.material, jacobian, kappa);
  // Kernels of a 40th of the map have spectra nine steps wide, which a window of one step bends by
  // (1 / 9)^2.
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(known(k, k) / alone(k, k), 1.0, 0.06) << k;
}

}  // namespace
}  // namespace hada
