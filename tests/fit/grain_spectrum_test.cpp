#include "fit/grain_spectrum.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/fft.h"
#include "core/random.h"

namespace hada {
namespace {

TEST(GrainSpectrum, OfWhiteNoiseIsFlat) {
  Grid<float> noise(128, 256);
  for (int row = 0; row < 128; ++row) {
    for (int col = 0; col < 256; ++col) noise(row, col) = float(gaussian(5, row, col));
  }
  const auto spectrum = grain_spectrum(noise);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
    sum += spectrum.count[i] * spectrum.power[i];
    count += spectrum.count[i];
  }
  // Variance 1 a pixel: mean 1, known to 1 / sqrt of the independent ordinates; four of those.
  EXPECT_NEAR(sum / count, 1.0, 4.0 / std::sqrt(count));
  EXPECT_EQ(spectrum.power.rows(), spectrum.y.cells());
  EXPECT_EQ(spectrum.power.cols(), spectrum.x.cells());
}

TEST(GrainSpectrum, SeesAFlatDensityAsItIs) {
  const auto spectrum = grain_spectrum(Grid<float>(64, 64, 0.5f));
  const std::vector<double> flat(256, 3.0);
  for (const double seen : seen_through(spectrum.x, flat)) EXPECT_NEAR(seen, 3.0, 1e-6);
  const std::vector<double> same(33, 2.0);
  for (const double mean : cell_means(spectrum.x, same)) EXPECT_NEAR(mean, 2.0, 1e-12);
}

/// Powers of the transform of a line, at the frequencies 0 to the Nyquist one.
std::vector<double> powers(const Grid<double>& line) {
  std::vector<double> at;
  for (const auto& value : fft(line)) at.push_back(std::norm(value));
  return at;
}

TEST(GrainSpectrum, OfAProductIsTheProductOfTheMeansOverTheCells) {
  // White lines: all frequencies, the Nyquist one too, have a power of their own.
  Grid<double> along(1, 96), down(1, 64);
  for (int k = 0; k < 96; ++k) along(0, k) = gaussian(6, k);
  for (int k = 0; k < 64; ++k) down(0, k) = gaussian(7, k);
  Grid<float> product(64, 96);
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 96; ++col) product(row, col) = float(down(0, row) * along(0, col));
  }
  const auto spectrum = grain_spectrum(product, {.taper = 0.0, .growth = 0.3});
  const auto x = cell_means(spectrum.x, powers(along)), y = cell_means(spectrum.y, powers(down));
  for (int r = 2; r < spectrum.y.cells(); ++r) {
    for (int c = 2; c < spectrum.x.cells(); ++c) {
      const double mean = x[std::size_t(c)] * y[std::size_t(r)] / (64.0 * 96.0);
      EXPECT_NEAR(spectrum.power(r, c), mean, 1e-5 * mean + 1e-9) << r << " " << c;
    }
  }
}

}  // namespace
}  // namespace hada
