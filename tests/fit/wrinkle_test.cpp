#include "fit/wrinkle.h"

#include <algorithm>
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
  expected[8] = 0.002 * 0.002 * 0.04;  // the floor: variance of the noise times pixel area
  std::size_t k = 0;
  visit_fields(fit.material, [&](const std::string& path, const auto& field, double value) {
    const double error = field.scale == Scale::half_turn
                             ? half_turn(value - expected[k] + pi / 2) - pi / 2
                             : value - expected[k];
    if (is_left_out(field, value)) {
      EXPECT_EQ(sigma[k], 0.0) << path;  // ridges were not asked for
    } else {
      EXPECT_LT(std::abs(error), 4.0 * sigma[k]) << path;
      EXPECT_LT(sigma[k], 0.2 * std::max(value, 1e-12)) << path;  // and the sigma says something
    }
    ++k;
  });
  EXPECT_GT(fit.goodness_p, 1e-3);
  EXPECT_EQ(fit.starts, 8);
}

TEST(FitWrinkle, HasIntervalsThatHoldTheTruth) {
  int held = 0, asked = 0;
  for (Seed seed = 10; seed < 20; ++seed) {
    const auto fit = fit_wrinkle(sample(truth, 160, seed), {.components = 2});
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& found = fit.material.components[k];
      const auto& sigma = fit.sigma.components[k];
      const auto& right = truth.components[k];
      const double turned = half_turn(found.angle_rad - right.angle_rad + pi / 2) - pi / 2;
      const auto holds = [](double error, double deviation) {
        return std::abs(error) < 1.96 * deviation ? 1 : 0;
      };
      held += holds(found.amplitude_mm - right.amplitude_mm, sigma.amplitude_mm);
      held += holds(found.long_mm - right.long_mm, sigma.long_mm);
      held += holds(found.short_mm - right.short_mm, sigma.short_mm);
      held += holds(turned, sigma.angle_rad);
      asked += 4;
    }
  }
  // 95 % of 80 is 76; amplitude and lengths move together, so that some 40 answers are
  // independent: a deviation of 2.8, three of them.
  EXPECT_GE(held, 76 - 8) << "of " << asked;
}

TEST(FitWrinkle, IsNotLedAstrayByAliases) {
  // Without noise, the alias of a kernel thinner than a pixel is the brightest thing near the
  // Nyquist frequency that the model does not know; it once took a component for itself.
  const Wrinkle<> thin{.components = {{0.4, 1.6, 0.8, 2.3}, {0.05, 0.5, 0.19, 1.8}}};
  for (const int components : {2, 0}) {
    const auto fit = fit_wrinkle(sample(thin, 192, 15, 0.0), {.components = components});
    ASSERT_EQ(fit.material.components.size(), 2u);
    const auto& found = fit.material.components[1];
    const auto& sigma = fit.sigma.components[1];
    EXPECT_LT(std::abs(found.amplitude_mm - 0.05), 4.0 * sigma.amplitude_mm);
    EXPECT_LT(std::abs(found.long_mm - 0.5), 4.0 * sigma.long_mm);
    EXPECT_LT(std::abs(found.short_mm - 0.19), 4.0 * sigma.short_mm);
    EXPECT_GT(fit.goodness_p, 1e-3);
    EXPECT_GT(fit.agreeing, 1);
  }
}

TEST(FitWrinkle, FindsTheLongestAxisWithoutBias) {
  // Cells of the flank that were kept for their own strength made it 0.7 sigma too short.
  double bias = 0.0;
  constexpr int count = 16;
  for (int seed = 0; seed < count; ++seed) {
    const auto fit = fit_wrinkle(sample(truth, 128, Seed(40 + seed), 0.0), {.components = 2});
    const double sigma = fit.sigma.components[0].long_mm;
    bias += (fit.material.components[0].long_mm - 1.6) / sigma / count;
  }
  EXPECT_LT(std::abs(bias), 3.0 / std::sqrt(count));  // three deviations of a mean of 16
}

TEST(FitWrinkle, ChoosesTheNumberOfComponents) {
  const auto fit = fit_wrinkle(sample(truth, 160, 2), {.most_components = 3});
  EXPECT_EQ(fit.material.components.size(), 2u);
}

TEST(FitWrinkle, TakesNoLeakageForWrinklesWhereNothingElseHidesIt) {
  // One wide noise function and no noise: its spectrum falls below the side lobes of the taper.
  const Wrinkle<> wide{.components = {{0.4, 1.6, 1.3, 0.5}}};
  double length = 0.0, breadth = 0.0, held = 0.0;
  constexpr int maps = 6;
  for (Seed seed = 30; seed < 30 + maps; ++seed) {
    const auto fit = fit_wrinkle(sample(wide, 224, seed, 0.0));
    ASSERT_EQ(fit.material.components.size(), 1u) << seed;
    EXPECT_GT(fit.goodness_p, 1e-3) << seed;
    const auto &found = fit.material.components[0], &sigma = fit.sigma.components[0];
    length += (found.long_mm - 1.6) / sigma.long_mm;
    breadth += (found.short_mm - 1.3) / sigma.short_mm;
    held += std::abs(found.amplitude_mm - 0.4) < 1.96 * sigma.amplitude_mm;
  }
  // Three deviations of a mean; leakage taken for a floor made both axes three sigma too short.
  EXPECT_LT(std::abs(length / maps), 3.0 / std::sqrt(maps));
  EXPECT_LT(std::abs(breadth / maps), 3.0 / std::sqrt(maps));
  EXPECT_GE(held, maps - 2);
}

TEST(FitWrinkle, SaysWhereMostOfTheMapIsAPlane) {
  auto surface = sample(truth, 64, 1);
  const auto tilted = [](const Fit<Wrinkle<>>& fit) {
    return std::count_if(fit.remarks.begin(), fit.remarks.end(), [](const auto& remark) {
      return remark.starts_with("Most of the height");
    });
  };
  EXPECT_EQ(tilted(fit_wrinkle(surface, {.components = 1})), 0);
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) surface.height(row, col) += float(0.05 * (col - 31.5));
  }
  EXPECT_EQ(tilted(fit_wrinkle(surface, {.components = 1})), 1);
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
