#include "measure/spectral_hills.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// Exponential ordinates about two humps of equal height, one octave and a quarter turn apart.
Spectrum two_humps() {
  Spectrum spectrum;
  spectrum.extent = {256, 256, 1.0, Unit::mm};
  spectrum.power = Grid<double>(256, 256);
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 256; ++col) {
      const double x = std::abs(spectrum.fx(col)), y = std::abs(spectrum.fy(row));
      const auto hump = [&](double fx, double fy) {
        return std::exp(-0.5 * (std::pow(x - fx, 2) + std::pow(y - fy, 2)) / (0.02 * 0.02));
      };
      spectrum.power(row, col) =
          (hump(0.1, 0.0) + hump(0.0, 0.2) + 1e-9) * -std::log(uniform(7, row, col));
    }
  }
  return spectrum;
}

TEST(SpectralHills, GiveEachHumpItsSurroundings) {
  const auto spectrum = two_humps();
  const auto found = spectral_hills(spectrum);
  const auto at = [&](double fx, double fy) {
    const int col = int(std::lround(fx * 256)), row = int(std::lround(-fy * 256));
    return found.of_ordinate((row + 256) % 256, (col + 256) % 256);
  };
  EXPECT_EQ(at(0.1, 0.0), at(-0.1, 0.0));
  EXPECT_EQ(at(0.1, 0.0), at(0.12, 0.01));
  EXPECT_EQ(at(0.0, 0.2), at(0.0, -0.2));
  EXPECT_NE(at(0.1, 0.0), at(0.0, 0.2));
  EXPECT_GE(at(0.1, 0.0), 0);
  EXPECT_GE(at(0.0, 0.2), 0);
  EXPECT_EQ(at(0.0, 0.0), -1);
  EXPECT_EQ(at(0.45, 0.45), -1);
}

}  // namespace
}  // namespace hada
