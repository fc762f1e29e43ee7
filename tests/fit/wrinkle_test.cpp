#include "fit/wrinkle.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
const Wrinkle<> truth{.components = {{0.4, 1.6, 0.8, 0.5}, {0.08, 0.45, 0.25, 2.0}}};

/// A cut from the middle of a larger field, every second pixel of it, with noise: no tiling, and
/// other frequencies than those of the fit.
Surface sample(const Wrinkle<>& wrinkle, int size, Seed seed, double noise = 0.002) {
  const auto field = synthesize(wrinkle, {4 * size, 4 * size, 0.1, Unit::mm}, seed).height;
  Surface surface;
  surface.extent = {size, size, 0.2, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.height = Grid<float>(size, size);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      surface.height(row, col) =
          field(size + 2 * row, size + 2 * col) + float(noise * gaussian(seed + 100, row, col));
    }
  }
  return surface;
}

TEST(FitWrinkle, FindsTheTruthWithinItsSigma) {
  const auto fit = fit_wrinkle(sample(truth, 192, 1), {.components = 2});
  std::vector<double> sigma, expected;
  visit_fields(fit.sigma, [&](const std::string&, const auto&, double s) { sigma.push_back(s); });
  visit_fields(truth, [&](const std::string&, const auto&, double v) { expected.push_back(v); });
  expected.back() = 0.002 * 0.002 * 0.04;  // the noise, variance times pixel area
  std::size_t k = 0;
  visit_fields(fit.material, [&](const std::string& path, const auto& field, double value) {
    const double error = field.scale == Scale::half_turn
                             ? half_turn(value - expected[k] + pi / 2) - pi / 2
                             : value - expected[k];
    EXPECT_LT(std::abs(error), 4.0 * sigma[k]) << path;
    EXPECT_LT(sigma[k], 0.2 * std::max(value, 1e-12)) << path;  // and the sigma says something
    ++k;
  });
  EXPECT_GT(fit.goodness_p, 1e-3);
  EXPECT_EQ(fit.starts, 8);
}

TEST(FitWrinkle, ChoosesTheNumberOfComponents) {
  const auto fit = fit_wrinkle(sample(truth, 160, 2), {.most_components = 3});
  EXPECT_EQ(fit.material.components.size(), 2u);
}

TEST(FitWrinkle, WritesWhatItFindsAsEveryoneWould) {
  const auto fit = fit_wrinkle(sample(truth, 160, 3), {.components = 2});
  const auto& c = fit.material.components;
  EXPECT_GT(c[0].long_mm, c[1].long_mm);
  for (const auto& component : c) {
    EXPECT_GE(component.long_mm, component.short_mm);
    EXPECT_GE(component.angle_rad, 0.0);
    EXPECT_LT(component.angle_rad, pi);
  }
}

TEST(FitWrinkle, HasTheSameBytesAtAnyThreadCount) {
  const auto surface = sample(truth, 96, 4);
  set_threads(1);
  const auto alone = fit_wrinkle(surface, {.components = 2});
  set_threads(3);
  const auto shared = fit_wrinkle(surface, {.components = 2});
  set_threads(0);
  EXPECT_EQ(pack(alone.material), pack(shared.material));
  EXPECT_EQ(pack(alone.sigma), pack(shared.sigma));
}

TEST(FitWrinkle, ReadsTheBrightnessOfASurfaceWithoutHeight) {
  auto surface = sample(truth, 96, 5);
  surface.albedo = Image(surface.height);
  surface.height = {};
  surface.extent.unit = Unit::px;
  const auto fit = fit_wrinkle(surface, {.components = 1});
  ASSERT_GE(fit.remarks.size(), 2u);
  EXPECT_NE(fit.remarks[0].find("brightness"), std::string::npos);
  EXPECT_NE(fit.remarks[1].find("pixels"), std::string::npos);
}

TEST(FitWrinkle, RefusesWhatHasNoWrinkles) {
  Surface flat;
  flat.extent = {64, 64, 0.2, Unit::mm};
  flat.mask = full_mask(flat.extent);
  EXPECT_THROW(fit_wrinkle(flat), Error);  // neither height nor albedo
  flat.height = Grid<float>(64, 64);
  EXPECT_THROW(fit_wrinkle(flat), Error);  // no relief
  auto small = sample(truth, 24, 1);
  EXPECT_THROW(fit_wrinkle(small), Error);
}

}  // namespace
}  // namespace hada
