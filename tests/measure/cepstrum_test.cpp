#include "measure/cepstrum.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/surface.h"
#include "synth/gaussian_field.h"
#include "synth/wrinkle.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 256, .cols = 256, .pitch = 0.1, .unit = Unit::mm};

Spectrum spectrum_of_field(const Wrinkle<>& wrinkle) {
  return power_spectrum(gaussian_field(spectrum_of(wrinkle), extent, 4), full_mask(extent), extent);
}

// Threads under stronger noise that does not come back.
Wrinkle<> threads() {
  Wrinkle<> wrinkle;
  wrinkle.components = {{.amplitude_mm = 0.2, .long_mm = 0.3, .short_mm = 0.2, .angle_rad = 0.4}};
  wrinkle.repeated = {{.amplitude_mm = 0.1,
                       .long_mm = 0.1,
                       .short_mm = 0.05,
                       .angle_rad = 1.0,
                       .period_mm = 1.13,
                       .period_angle_rad = 1.9,
                       .repeats = 2.0}};
  wrinkle.floor_mm4 = 1e-6;  // beyond it lies what the taper lets through
  return wrinkle;
}

TEST(Cepstrum, FindsThePeriodOfWhatComesBack) {
  const auto found = repetitions(
      spectrum_of_field(threads()), [](double, double) { return 1e-3; }, 0.2, 2.0, 3);
  ASSERT_EQ(found.size(), 3u);
  const Eigen::Vector2d period(1.13 * std::cos(1.9), 1.13 * std::sin(1.9));
  const double off = std::min((found[0] - period).norm(), (found[0] + period).norm());
  EXPECT_LT(off, 0.1);  // a pixel, which the parabola halves
}

TEST(Cepstrum, SaysNothingAgainOfWhatIsExpected) {
  const auto wrinkle = threads();
  const auto found = repetitions(spectrum_of_field(wrinkle), spectrum_of(wrinkle), 0.2, 2.0, 1);
  ASSERT_EQ(found.size(), 1u);
  const Eigen::Vector2d period(1.13 * std::cos(1.9), 1.13 * std::sin(1.9));
  EXPECT_GT(std::min((found[0] - period).norm(), (found[0] + period).norm()), 0.2);
}

TEST(Cepstrum, KeepsToTheDistancesThatAreAskedFor) {
  for (const auto& distance : repetitions(
           spectrum_of_field(threads()), [](double, double) { return 1.0; }, 0.5, 0.9, 20)) {
    EXPECT_GE(distance.norm(), 0.5);
    EXPECT_LE(distance.norm(), 0.9);
  }
}

}  // namespace
}  // namespace hada
