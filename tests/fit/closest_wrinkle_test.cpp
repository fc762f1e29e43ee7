#include "fit/closest_wrinkle.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cut_picture.h"
#include "fit/wrinkle.h"

namespace hada {
namespace {

// Scales without a size of their own, drawn out along x: no sum of Gaussian kernels.
double fractal_psd(double fx, double fy) {
  return 1e-3 / std::pow(0.04 + 4.0 * fx * fx + fy * fy, 1.3);
}

/// Mean and root mean square over the plane of how far the model is from the truth, in dB.
std::pair<double, double> distance_db(const Wrinkle<>& wrinkle) {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (double fy = -4.95; fy < 5.0; fy += 0.1) {
    for (double fx = 0.05; fx < 5.0; fx += 0.1) {
      const double db = 10.0 * std::log10(psd(wrinkle, fx, fy) / fractal_psd(fx, fy));
      sum += db;
      squares += db * db;
      ++count;
    }
  }
  return {sum / count, std::sqrt(squares / count)};
}

TEST(ClosestWrinkle, ComesNearASpectrumThatIsNoWrinkles) {
  const auto fit = fit_wrinkle(cut_picture(fractal_psd, 3));
  const Wrinkle<>& found = fit.material;
  EXPECT_GE(found.components.size() + found.repeated.size() + found.woven.size(), 3u);
  const auto [bias, rms] = distance_db(fit.material);
  // Five Gaussian curves over two decades are one for each factor of 2.5: a sum of such, fitted to
  // a power law of this slope, undulates by 0.5 dB. Twice that, since the data are one realisation.
  EXPECT_LT(rms, 1.0);
  EXPECT_LT(std::abs(bias), 0.3);
}

TEST(ClosestWrinkle, IsUnsureOfWhatExplainsBadly) {
  const auto surface = cut_picture(fractal_psd, 4);
  const auto observed = observe(surface);
  const auto fit = closest_wrinkle(observed, 1);
  ASSERT_EQ(fit.material.components.size(), 1u);
  // A tenth of the scatter of 256 x 256 / 2 ordinates would be 0.1 %.
  EXPECT_GT(fit.sigma.components[0].amplitude_mm, 0.005 * fit.material.components[0].amplitude_mm);
}

// Lines across the threads, as twill has them, over a ground that falls off.
double twill_psd(double fx, double fy) {
  const double line = std::pow(std::sin(std::numbers::pi * (0.3 * fx + 1.0 * fy)), 2);
  return (1e-6 + 1e-4 / (1.0 + 30.0 * line)) * std::exp(-0.2 * (fx * fx + fy * fy));
}

TEST(ClosestWrinkle, MakesWhatComesBack) {
  const auto fit = fit_wrinkle(cut_picture(twill_psd, 6), {.components = 2});
  ASSERT_EQ(fit.material.repeated.size(), 1u);
  ASSERT_EQ(fit.material.components.size(), 1u);
  double squares = 0.0, plain = 0.0;
  int count = 0;
  for (double fy = -4.0; fy < 4.0; fy += 0.11) {
    for (double fx = 0.05; fx < 4.0; fx += 0.11) {
      const double level = 1e-5 * std::exp(-0.2 * (fx * fx + fy * fy));
      squares += std::pow(10.0 * std::log10(psd(fit.material, fx, fy) / twill_psd(fx, fy)), 2);
      plain += std::pow(10.0 * std::log10(level / twill_psd(fx, fy)), 2);
      ++count;
    }
  }
  // Lines of another shape than a Gaussian's: what is left is a third of what no lines would leave.
  EXPECT_LT(std::sqrt(squares / count), std::sqrt(plain / count) / 3.0);
  EXPECT_NEAR(fit.material.repeated[0].period_mm, std::hypot(0.3, 1.0), 0.02);
}

TEST(ClosestWrinkle, LeavesWrinklesAlone) {
  Wrinkle<> truth;
  truth.components = {{.amplitude_mm = 0.1, .long_mm = 0.6, .short_mm = 0.3, .angle_rad = 0.4}};
  const auto fit = fit_wrinkle(cut_picture(spectrum_of(truth), 6), {.components = 1});
  // 256 x 256 pixels hold about 1000 waves of this size: its length is known to 2 %, times 4.
  EXPECT_NEAR(fit.material.components[0].long_mm, 0.6, 0.05);
  EXPECT_GT(fit.goodness_p, 1e-3);
}

}  // namespace
}  // namespace hada
