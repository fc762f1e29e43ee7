#include "measure/roughness.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/extent.h"
#include "core/parallel.h"
#include "core/surface.h"
#include "synth/gaussian_field.h"
#include "synth/wrinkle.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

// Amplitude 0.5 mm, whole periods along both sides, crests at 45 degrees below the x axis.
constexpr Extent waves_extent{.rows = 256, .cols = 256, .pitch = 0.1, .unit = Unit::mm};
constexpr double waves_per_side = 8.0;

Grid<float> waves() {
  Grid<float> height(waves_extent.rows, waves_extent.cols);
  for (int row = 0; row < height.rows(); ++row) {
    for (int col = 0; col < height.cols(); ++col) {
      const Eigen::Vector2d place = waves_extent.place(row, col);
      const double phase = 2.0 * pi * waves_per_side * place.sum() / waves_extent.width();
      height(row, col) = float(0.5 * std::sin(phase) + 3.0);
    }
  }
  return height;
}

TEST(Roughness, OfASinusoidIsItsClosedForm) {
  const Roughness found = roughness(waves(), full_mask(waves_extent), waves_extent.pitch);
  const double k = 2.0 * pi * waves_per_side / waves_extent.width();  // along x and along y
  // 32 samples a period miss a crest by at most 1 / 64 of it: 0.5 % of the amplitude.
  EXPECT_NEAR(found.Sp, 0.5, 0.0025);
  EXPECT_NEAR(found.Sv, 0.5, 0.0025);
  EXPECT_NEAR(found.Sz, 1.0, 0.005);
  EXPECT_NEAR(found.Sa, 0.5 * 2.0 / pi, 0.0025);
  EXPECT_NEAR(found.Sq, 0.5 / std::sqrt(2.0), 1e-5);  // sums over whole periods are exact
  EXPECT_NEAR(found.Ssk, 0.0, 1e-4);
  EXPECT_NEAR(found.Sku, 1.5, 1e-4);
  // A difference over one pitch shortens the slope by (k pitch)^2 / 24 = 0.16 %.
  EXPECT_NEAR(found.Sdq, found.Sq * k * std::sqrt(2.0), 0.003 * found.Sq * k * std::sqrt(2.0));
  // cos(k_across lag) = 0.2; bilinear reading errs by k^2 pitch^2 / 8 = 0.5 %.
  EXPECT_NEAR(found.Sal, std::acos(0.2) / (k * std::sqrt(2.0)), 0.02 * found.Sal);
  // Along the crests it never falls: the longest lag is half of the diagonal.
  EXPECT_LT(found.Str, 0.05);
  EXPECT_NEAR(found.Std, 0.75 * pi, 1e-3);
}

TEST(Roughness, OfAPlaneHasItsDevelopedArea) {
  Grid<float> height(40, 50);
  for (int row = 0; row < 40; ++row) {
    for (int col = 0; col < 50; ++col) height(row, col) = float(0.2 * (0.75 * col - 0.5 * row));
  }
  const Roughness found = roughness(height, Mask(40, 50, 1), 0.2);
  // Heights up to 7.5 are floats: slopes are good to 5e-7 / 0.2.
  EXPECT_NEAR(found.Sdr, std::sqrt(1.0 + 0.75 * 0.75 + 0.5 * 0.5) - 1.0, 1e-5);
  EXPECT_NEAR(found.Sdq, std::hypot(0.75, 0.5), 1e-5);
}

TEST(Roughness, OfAGaussianFieldIsWhatItsSpectrumSays) {
  const WrinkleComponent<> component{
      .amplitude_mm = 0.2, .long_mm = 0.8, .short_mm = 0.4, .angle_rad = 0.6};
  const Extent extent{.rows = 512, .cols = 512, .pitch = 0.1, .unit = Unit::mm};
  const auto height =
      gaussian_field([&](double fx, double fy) { return psd(component, fx, fy); }, extent, 5);
  const Roughness found = roughness(height, full_mask(extent), extent.pitch);
  // The field has 51.2^2 / (4 pi 0.8 0.4) = 650 independent patches: the variance is good to
  // sqrt(2 / 650) = 5.5 %, skewness to sqrt(6 / 650), kurtosis to sqrt(24 / 650); three times that.
  EXPECT_NEAR(found.Sq, 0.2, 0.2 * 0.083);
  EXPECT_NEAR(found.Ssk, 0.0, 0.29);
  EXPECT_NEAR(found.Sku, 3.0, 0.58);
  // The autocorrelation exp(-d^2 / (4 short^2)) falls to 0.2 at 2 short sqrt(ln 5); the variance of
  // a slope along each axis is Sq^2 / (2 length^2).
  EXPECT_NEAR(found.Sal, 2.0 * 0.4 * std::sqrt(std::log(5.0)), 0.15 * found.Sal);
  EXPECT_NEAR(found.Str, 0.5, 0.1);
  EXPECT_NEAR(found.Sdq, 0.2 * std::sqrt(0.5 / 0.16 + 0.5 / 0.64), 0.1 * found.Sdq);
  EXPECT_NEAR(found.Std, 0.6, 0.1);
}

TEST(RoughnessEstimate, KnowsHowMuchItScattersOverRealisations) {
  const WrinkleComponent<> component{
      .amplitude_mm = 0.2, .long_mm = 0.8, .short_mm = 0.4, .angle_rad = 0.6};
  const Extent world{.rows = 384, .cols = 384, .pitch = 0.1, .unit = Unit::mm};
  constexpr int seeds = 100;
  std::vector<RoughnessEstimate> found;
  for (int seed = 0; seed < seeds; ++seed) {
    // A quarter of a field that tiles does not tile.
    const auto field = gaussian_field([&](double fx, double fy) { return psd(component, fx, fy); },
                                      world, Seed(seed));
    found.push_back(roughness_estimate(crop(field, 0, 0, 192, 192), Mask(192, 192, 1), 0.1));
  }
  for (const RoughnessField& field : roughness_fields) {
    double mean = 0.0, squares = 0.0, sigma_squares = 0.0;
    for (const auto& one : found) {
      mean += one.value.*(field.value) / seeds;
      sigma_squares += std::pow(one.sigma.*(field.value), 2) / seeds;
    }
    for (const auto& one : found) squares += std::pow(one.value.*(field.value) - mean, 2);
    const double scatter = std::sqrt(squares / (seeds - 1));
    // The scatter of 100 values is known to 1 / sqrt(198) = 7 %; three of those. The law of the
    // extremes takes hills for independent: over 400 fields their sigma is 1.4 times the scatter,
    // as that of Str, a ratio of two lengths. Hills keep a distance and so stand more evenly than
    // by chance, which is what their sigma supposes: 1.8 times.
    const double most = field.name == "Spd" ? 2.5 : 1.7;
    EXPECT_GT(std::sqrt(sigma_squares), 0.6 * scatter) << field.name;
    EXPECT_LT(std::sqrt(sigma_squares), most * scatter) << field.name;
  }
}

TEST(Roughness, DoesNotReadOutsideTheMask) {
  Grid<float> height = waves();
  Mask mask = full_mask(waves_extent);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 90; ++col) mask(row, col) = 0;
  }
  const Roughness before = roughness(height, mask, 0.1);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) height[i] = std::nanf("");
  }
  const Roughness after = roughness(height, mask, 0.1);
  EXPECT_EQ(before.Sq, after.Sq);
  EXPECT_EQ(before.Sal, after.Sal);
  EXPECT_EQ(before.Std, after.Std);
}

TEST(Roughness, IsTheSameAtAnyThreadCount) {
  set_threads(1);
  const Roughness one = roughness(waves(), full_mask(waves_extent), 0.1);
  set_threads(2);
  const Roughness two = roughness(waves(), full_mask(waves_extent), 0.1);
  set_threads(0);
  EXPECT_EQ(one.Sq, two.Sq);
  EXPECT_EQ(one.Sdq, two.Sdq);
  EXPECT_EQ(one.Sal, two.Sal);
}

TEST(Roughness, OfAMirrorIsZero) {
  const Roughness found = roughness(Grid<float>(20, 20, 2.0f), Mask(20, 20, 1), 1.0);
  EXPECT_EQ(found.Sq, 0.0);
  EXPECT_EQ(found.Sal, 0.0);
}

TEST(Roughness, RefusesAFewPixels) {
  EXPECT_THROW(roughness(Grid<float>(5, 5), Mask(5, 5, 1), 1.0), Error);
}

}  // namespace
}  // namespace hada
