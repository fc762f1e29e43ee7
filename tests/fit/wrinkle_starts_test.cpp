#include "fit/wrinkle_starts.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

Spectrum spectrum_of(const Wrinkle<>& wrinkle) {
  const auto surface = synthesize(wrinkle, {256, 256, 0.2, Unit::mm}, 4);
  return power_spectrum(surface.height, surface.mask, surface.extent);
}

TEST(WrinkleStarts, BracketTheSizeOfALoneComponent) {
  const auto starts = wrinkle_starts(spectrum_of({.components = {{0.3, 1.5, 0.7, 0.6}}}), 1, 8);
  ASSERT_EQ(starts.size(), 8u);
  double smallest = 1e9, largest = 0.0;
  for (const auto& start : starts) {
    ASSERT_EQ(start.components.size(), 1u);
    const auto& c = start.components[0];
    smallest = std::min(smallest, std::sqrt(c.long_mm * c.short_mm));
    largest = std::max(largest, std::sqrt(c.long_mm * c.short_mm));
  }
  EXPECT_LT(smallest, std::sqrt(1.5 * 0.7));
  EXPECT_GT(largest, 0.5 * std::sqrt(1.5 * 0.7));
}

TEST(WrinkleStarts, StayInsideTheBounds) {
  for (const auto& start : wrinkle_starts(spectrum_of({}), 4, 15)) {
    visit_fields(start, [](const std::string& path, const auto& field, double value) {
      EXPECT_GE(value, field.low) << path;
      EXPECT_LE(value, field.high) << path;
    });
  }
}

TEST(WithOneMore, PutsAComponentWhereTheModelFallsShort) {
  const WrinkleComponent<> wide{0.3, 3.0, 2.0, 0.3}, narrow{0.05, 0.6, 0.4, 1.5};
  const auto spectrum = spectrum_of({.components = {wide, narrow}});
  const auto cells = cells_of(spectrum, leakage(spectrum));
  const Wrinkle<> known{.components = {wide}, .floor_mm4 = 1e-9};
  std::vector<double> model;
  for (const Cell& cell : cells) model.push_back(psd(known, cell.fx, cell.fy));
  const auto more = with_one_more(known, cells, model);
  ASSERT_EQ(more.components.size(), 2u);
  const auto& added = more.components[1];
  const double size = std::sqrt(added.long_mm * added.short_mm);
  EXPECT_GT(size, 0.1);
  EXPECT_LT(size, 1.5);
}

}  // namespace
}  // namespace hada
