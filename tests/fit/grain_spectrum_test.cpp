#include "fit/grain_spectrum.h"

#include <cmath>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace hada
