#include "synth/ridges.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/fft.h"
#include "core/parallel.h"
#include "synth/gaussian_field.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

const Extent extent{256, 256, 0.1, Unit::mm};

Wrinkle<> sheet(double skew, double tail, double sharpness) {
  Wrinkle<> wrinkle{.components = {{0.2, 1.2, 0.8, 0.5}, {0.03, 0.4, 0.25, 2.0}}};
  wrinkle.skew = skew;
  wrinkle.tail = tail;
  wrinkle.sharpness = sharpness;
  return wrinkle;
}

struct Shape {
  double skewness, kurtosis;
};

Shape shape_of(const std::vector<double>& values) {
  const auto n = double(values.size());
  double mean = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  for (const double v : values) mean += v / n;
  for (const double v : values) {
    const double d = v - mean;
    m2 += d * d / n;
    m3 += d * d * d / n;
    m4 += d * d * d * d / n;
  }
  return {m3 / std::pow(m2, 1.5), m4 / (m2 * m2)};
}

Shape heights(const Grid<float>& h) {
  return shape_of({h.begin(), h.end()});
}

Shape curvatures(const Grid<float>& h) {
  std::vector<double> values;
  for (int row = 1; row + 1 < h.rows(); ++row) {
    for (int col = 1; col + 1 < h.cols(); ++col)
      values.push_back(h(row + 1, col) + h(row - 1, col) + h(row, col + 1) + h(row, col - 1) -
                       4.0 * h(row, col));
  }
  return shape_of(values);
}

TEST(HeightTransport, LeavesMeanAndVarianceOfANormalNumber) {
  const HeightTransport plain(0.0, 0.0), bent(0.6, 0.2);
  double mass = 0.0, mean = 0.0, square = 0.0;
  for (double z = -9.0; z <= 9.0; z += 0.001) {
    EXPECT_NEAR(plain(z), z, 1e-12);
    EXPECT_LT(bent(z), bent(z + 0.001));  // increasing: nothing is folded over
    mass += std::exp(-0.5 * z * z);
    mean += std::exp(-0.5 * z * z) * bent(z);
    square += std::exp(-0.5 * z * z) * bent(z) * bent(z);
  }
  EXPECT_NEAR(mean / mass, 0.0, 1e-6);
  EXPECT_NEAR(square / mass, 1.0, 1e-6);
}

TEST(Sharpen, MakesOfAWaveWhatTheFormulaSays) {
  // A cosine along x: at a place x the minimum over y of cos(k y) + (x - y)^2 / (2 r), by search.
  constexpr int n = 128;
  constexpr double k = 2.0 * std::numbers::pi * 2.0 / n, radius = 0.9 / (k * k);
  for (const double sign : {1.0, -1.0}) {
    Grid<float> wave(4, n);
    for (int row = 0; row < 4; ++row) {
      for (int col = 0; col < n; ++col) wave(row, col) = float(std::cos(k * col));
    }
    sharpen(wave, sign * radius, true);
    for (int col = 0; col < n; ++col) {
      double lowest = HUGE_VAL;
      for (double y = col - 70.0; y <= col + 70.0; y += 0.01)
        lowest = std::min(lowest, sign * std::cos(k * y) + (col - y) * (col - y) / (2.0 * radius));
      // A parabola through three samples of a cosine errs by k^3 / 15 = 6e-5 in between.
      EXPECT_NEAR(wave(2, col), sign * lowest, 2e-4) << col;
    }
  }
}

TEST(Ridges, AreTheGaussianFieldWhereThereAreNone) {
  const auto plain = sheet(0.0, 0.0, 0.0);
  EXPECT_EQ(synthesize(plain, extent, 3).height, gaussian_field(spectrum_of(plain), extent, 3));
}

TEST(Ridges, MakePeaksExtremesAndCrestsAsTheySay) {
  const auto plain = heights(synthesize(sheet(0.0, 0.0, 0.0), extent, 4).height);
  const auto skewed = heights(synthesize(sheet(0.3, 0.0, 0.0), extent, 4).height);
  const auto tailed = heights(synthesize(sheet(0.0, 0.2, 0.0), extent, 4).height);
  EXPECT_GT(skewed.skewness, plain.skewness + 0.3);
  EXPECT_GT(tailed.kurtosis, plain.kurtosis + 0.5);
  // Crests are where the surface bends down.
  EXPECT_LT(curvatures(synthesize(sheet(0.0, 0.0, 2.8), extent, 4).height).skewness, -0.3);
  EXPECT_GT(curvatures(synthesize(sheet(0.0, 0.0, -2.8), extent, 4).height).skewness, 0.3);
}

TEST(Ridges, LeaveTheSpectrumAlone) {
  const auto power_in = [](const Grid<float>& h, double low, double high) {
    const auto half = fft(h);
    double sum = 0.0;
    for (int row = 0; row < half.rows(); ++row) {
      for (int col = 0; col < half.cols(); ++col) {
        const double f = std::hypot(col, signed_frequency(row, h.rows()));
        if (f >= low && f < high) sum += std::norm(half(row, col));
      }
    }
    return sum;
  };
  const auto plain = synthesize(sheet(0.0, 0.0, 0.0), extent, 5).height;
  const auto ridged = synthesize(sheet(0.3, 0.1, 3.5), extent, 5).height;
  for (const auto& [low, high] : {std::pair{6.0, 12.0}, {12.0, 24.0}, {24.0, 48.0}}) {
    // Hundreds of ordinates, each with its own luck, but the pooled power of its surroundings.
    EXPECT_NEAR(power_in(ridged, low, high) / power_in(plain, low, high), 1.0, 0.1) << low;
  }
}

TEST(Ridges, HaveTheSameBytesAtAnyThreadCount) {
  set_threads(1);
  const auto alone = synthesize(sheet(0.3, 0.1, 3.5), extent, 6).height;
  set_threads(3);
  const auto shared = synthesize(sheet(0.3, 0.1, 3.5), extent, 6).height;
  set_threads(0);
  EXPECT_EQ(alone, shared);
}

TEST(Ridges, AreOneSheetInEveryWindow) {
  const Extent window{48, 64, 0.1, Unit::mm};
  const auto wrinkle = sheet(0.3, 0.1, 2.8);
  const auto here = synthesize_window(wrinkle, window, {1.0, 2.0}, 4);
  const auto right = synthesize_window(wrinkle, window, {2.6, 2.0}, 4);
  for (int row = 0; row < 48; ++row) {
    for (int col = 16; col < 64; ++col)
      ASSERT_NEAR(here.height(row, col), right.height(row, col - 16), 2e-5);
  }
}

}  // namespace
}  // namespace hada
