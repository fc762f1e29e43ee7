#include "fit/spectral_distance.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fit/solve.h"

namespace hada {
namespace {

Wrinkle<> weave() {
  Wrinkle<> wrinkle;
  wrinkle.components = {{.amplitude_mm = 0.2, .long_mm = 0.3, .short_mm = 0.2, .angle_rad = 0.4}};
  wrinkle.repeated = {RepeatedNoise<>{}};
  wrinkle.woven = {WovenNoise<>{}};
  wrinkle.floor_mm4 = 1e-5;
  return wrinkle;
}

std::vector<Cell> cells() {
  std::vector<Cell> list;
  for (int k = 0; k < 40; ++k) {
    Cell cell;
    cell.fx = 0.05 * k;
    cell.fy = 0.7 - 0.03 * k;
    cell.count = 1 + k % 16;
    cell.xx = cell.yy = 0.01;
    cell.power = 1e-3 * std::exp(-0.1 * k);
    list.push_back(cell);
  }
  return list;
}

TEST(SpectralDistance, IsNoneWhereAllIsExplained) {
  auto list = cells();
  const auto model = densities(weave(), list);
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].power = model[i] * std::exp(-bias_of_log_mean(list[i].count));
  const auto distances = spectral_distances(list, 1.0);
  ASSERT_EQ(distances.count(), 41);
  std::vector<double> r(41);
  distances(weave(), r.data());
  for (int k = 0; k < 40; ++k) EXPECT_NEAR(r[std::size_t(k)], 0.0, 1e-12);
  // The mean of an exponential number is not that of its logarithm.
  EXPECT_LT(r[40], 0.0);
}

TEST(SpectralDistance, HearsTheWholePower) {
  auto list = cells();
  const auto model = densities(weave(), list);
  double weights = 0.0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].power = 4.0 * model[i];
    weights += std::pow(LogDistance{0.5}.weight(list[i]), 2);
  }
  std::vector<double> r(41);
  spectral_distances(list, 0.5)(weave(), r.data());
  EXPECT_NEAR(r[40], std::sqrt(0.05 * weights) * std::log(4.0), 1e-9);
}

TEST(SpectralDistance, HasTheDerivativesOfItsDifferences) {
  const auto list = cells();
  const auto distances = spectral_distances(list, 0.8);
  const auto shape = weave();
  const auto jacobian = jacobian_of(shape, distances.count(), distances);
  const auto packed = pack(shape);
  constexpr double h = 1e-6;
  for (std::size_t k = 0; k < packed.size(); ++k) {
    auto up = packed, down = packed;
    up[k] += h;
    down[k] -= h;
    std::vector<double> above(41), below(41);
    distances(unpack(shape, up.data()), above.data());
    distances(unpack(shape, down.data()), below.data());
    for (int i = 0; i < 41; ++i) {
      EXPECT_NEAR(jacobian(i, Eigen::Index(k)),
                  (above[std::size_t(i)] - below[std::size_t(i)]) / (2.0 * h), 1e-5)
          << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace hada
