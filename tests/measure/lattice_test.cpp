#include "measure/lattice.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "core/surface.h"

namespace hada {
namespace {

const Extent extent{300, 400, 0.1, Unit::mm};

// A sum of waves of amplitude 1 at whole combinations of two frequencies, with noise.
Grid<float> waves(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double noise) {
  Grid<float> map(extent.rows, extent.cols);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d place = extent.place(row, col);
      double sum = noise * gaussian(3, row, col);
      for (const auto& [i, j] : {std::pair{1, 1}, {2, 0}, {1, -1}, {0, 1}, {2, 1}, {3, 2}}) {
        sum += std::cos(2.0 * std::numbers::pi * (i * a + j * b).dot(place) + i + 2.0 * j);
      }
      map(row, col) = float(sum);
    }
  }
  return map;
}

Lattice lattice_seen(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double noise) {
  const auto spectrum =
      power_spectrum(waves(a, b, noise), full_mask(extent), extent, {.taper = 1.0});
  return lattice_of(spectral_peaks(spectrum), {1.0 / extent.width(), 1.0 / extent.height()});
}

TEST(SpectralPeaks, LieBetweenTheBins) {
  const Eigen::Vector2d a(0.613, 0.037), b(-0.041, 0.787);
  const auto spectrum = power_spectrum(waves(a, b, 0.0), full_mask(extent), extent, {.taper = 1.0});
  const auto peaks = spectral_peaks(spectrum);
  ASSERT_GE(peaks.size(), 6u);
  for (const Eigen::Vector2d& wave : {Eigen::Vector2d(a + b), Eigen::Vector2d(2.0 * a), b}) {
    double nearest = 1e9;
    for (const auto& peak : peaks) nearest = std::min(nearest, (peak.frequency - wave).norm());
    // The parabola in the logarithm errs by at most 0.035 bins for a Hann window, each way.
    EXPECT_LT(nearest, 0.05 / extent.height());
  }
}

TEST(LatticeOf, FindsTheBasisUnderNoise) {
  // Although the first wave of `a` is not among them.
  for (const double angle : {-0.3, 0.0, 0.07, 0.5}) {
    const Eigen::Vector2d a = 0.61 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d b = 0.79 * Eigen::Vector2d(-std::sin(angle + 0.02), std::cos(angle));
    const Lattice found = lattice_seen(a, b, 2.0);
    const auto off = [&](const Eigen::Vector2d& wanted) {
      return std::min({(found.first - wanted).norm(), (found.first + wanted).norm(),
                       (found.second - wanted).norm(), (found.second + wanted).norm()});
    };
    // Noise of 2 against waves of 1 over 120000 pixels moves a peak by 0.01 bins.
    EXPECT_LT(off(a), 0.05 / extent.height()) << angle;
    EXPECT_LT(off(b), 0.05 / extent.height()) << angle;
    EXPECT_GT(found.explained, 0.95);
  }
}

TEST(LatticeOf, EndsWhereTwoVectorsAreAsShort) {
  // Of the rows of bricks either neighbour above will do.
  const std::vector<SpectralPeak> peaks = {{{2.0, 0.0}, 1.0, 1e3}, {{1.0, 3.0}, 1.0, 1e3}};
  const Lattice found = lattice_of(peaks, {0.1, 0.1});
  EXPECT_NEAR(found.first.norm(), 2.0, 1e-12);
  EXPECT_NEAR(found.second.norm(), std::sqrt(10.0), 1e-12);
}

TEST(LatticeOf, FindsNoneInNoise) {
  Grid<float> map(extent.rows, extent.cols);
  for (std::size_t k = 0; k < map.size(); ++k) map[k] = float(gaussian(8, std::int64_t(k)));
  const auto spectrum = power_spectrum(map, full_mask(extent), extent, {.taper = 1.0});
  EXPECT_THROW(lattice_of(spectral_peaks(spectrum), {1.0, 1.0}), Error);
}

}  // namespace
}  // namespace hada
