#include "fit/unit_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "fit/wrinkle.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

TEST(UnitMap, HasPitchOneAndHeightsOfDeviationOne) {
  Surface surface;
  surface.extent = {64, 48, 0.004, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.mask(0, 0) = 0;
  surface.height = Grid<float>(64, 48);
  surface.normal_sigma = Grid<float>(64, 48, 0.01f);
  for (int i = 0; i < int(surface.height.size()); ++i)
    surface.height[std::size_t(i)] = 5e-5f * float(gaussian(2, i));
  surface.height(0, 0) = 7.0f;  // outside the mask
  const MapUnits units = units_of(surface);
  EXPECT_EQ(units.length, 0.004);
  EXPECT_NEAR(units.height / 5e-5, 1.0, 3.0 / std::sqrt(2.0 * 64 * 48));
  const Surface map = in_units(surface, units);
  EXPECT_EQ(map.extent.pitch, 1.0);
  EXPECT_NEAR(units_of(map).height, 1.0, 1e-6);  // floats
  // A slope is a height over a length.
  EXPECT_NEAR(map.normal_sigma(1, 1) * units.height / units.length, 0.01, 1e-8);
}

TEST(UnitMap, LeavesPicturesAndFlatMapsTheirHeights) {
  Surface flat;
  flat.extent = {8, 8, 2.0, Unit::mm};
  flat.mask = full_mask(flat.extent);
  flat.height = Grid<float>(8, 8, 3.0f);
  EXPECT_EQ(units_of(flat).height, 1.0);
  flat.albedo = Image(flat.height);
  flat.height = {};
  EXPECT_EQ(units_of(flat).height, 1.0);
  EXPECT_EQ(in_units(flat, units_of(flat)).albedo.planes.size(), 1u);
}

TEST(UnitMap, LetsAFitFindTheSameAtAnyScale) {
  const Wrinkle<> truth{.components = {{0.4, 1.6, 0.8, 0.5}, {0.05, 0.3, 0.22, 2.0}}};
  Surface surface = synthesize(truth, {128, 128, 0.2, Unit::mm}, 3);
  const auto fit = fit_wrinkle(surface, {.components = 2});
  // A map of a thousandth of the pitch and a ten thousandth of the height, and one of metres.
  for (const auto& [length, height] : {std::pair{1e-3, 1e-4}, std::pair{1e2, 1e3}}) {
    Surface other = surface;
    other.extent.pitch *= length;
    for (float& value : other.height) value = float(value * height);
    const auto found = fit_wrinkle(other, {.components = 2});
    for (std::size_t k = 0; k < 2; ++k) {
      const auto &a = fit.material.components[k], &b = found.material.components[k];
      EXPECT_NEAR(b.amplitude_mm / (height * a.amplitude_mm), 1.0, 1e-4);
      EXPECT_NEAR(b.long_mm / (length * a.long_mm), 1.0, 1e-4);
      EXPECT_NEAR(b.short_mm / (length * a.short_mm), 1.0, 1e-4);
      EXPECT_NEAR(b.angle_rad, a.angle_rad, 1e-4);
      EXPECT_NEAR(found.sigma.components[k].long_mm / (length * fit.sigma.components[k].long_mm),
                  1.0, 1e-3);
    }
    EXPECT_NEAR(found.goodness_p, fit.goodness_p, 1e-3);
    ASSERT_EQ(found.intervals.size(), fit.intervals.size());
    for (std::size_t k = 0; k < fit.intervals.size(); ++k) {
      if (fit.intervals[k].path != "floor_mm4") continue;
      EXPECT_NEAR(found.intervals[k].high / (std::pow(height * length, 2) * fit.intervals[k].high),
                  1.0, 0.02);
    }
  }
}

}  // namespace
}  // namespace hada
