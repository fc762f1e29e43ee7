#include "fit/classify.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

const std::vector<Wrinkle<>> kinds{
    {{{0.3, 6.0, 3.0, 0.0}}, 0.0},
    {{{0.3, 6.0, 3.0, 0.0}, {0.1, 1.6, 0.9, 0.1}}, 0.0},
    {{{0.15, 2.5, 1.2, 0.0}}, 0.0},
};

/// A part of a larger, finer field of a sheet that differs from its kind, turned, with noise.
Surface sheet_of(Wrinkle<> kind, double turn, Seed seed) {
  for (std::size_t k = 0; k < kind.components.size(); ++k) {
    auto& component = kind.components[k];
    component.amplitude_mm *= std::exp(0.08 * gaussian(seed, int(k), 1));
    component.long_mm *= std::exp(0.08 * gaussian(seed, int(k), 2));
    component.short_mm *= std::exp(0.08 * gaussian(seed, int(k), 3));
    component.angle_rad = half_turn(component.angle_rad + turn);
  }
  const auto field = synthesize(kind, {768, 768, 0.2, Unit::mm}, seed).height;
  Surface sheet;
  sheet.extent = {256, 256, 0.4, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = Grid<float>(256, 256);
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 256; ++col) {
      sheet.height(row, col) =
          field(2 * row + 100, 2 * col + 60) + float(0.002 * gaussian(seed + 99, row, col));
    }
  }
  return sheet;
}

TEST(Classify, NamesTheKindOfATurnedSheet) {
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const double turn = 0.4 + 0.3 * double(k);
    const auto found = classify(sheet_of(kinds[k], turn, 5 + k), kinds);
    ASSERT_EQ(found.size(), kinds.size());
    EXPECT_GT(found[k].probability, 0.9) << k;
    // Some 60 waves of the largest kind: its direction is good to a few degrees.
    EXPECT_NEAR(found[k].turn_rad, turn, 0.15) << k;
    EXPECT_NEAR(std::log(found[k].amplitude), 0.0, 0.4) << k;
    double sum = 0.0;
    for (const auto& one : found) sum += one.probability;
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(Classify, SaysWhenASheetIsOfNoKind) {
  const Wrinkle<> stranger{{{0.3, 1.0, 0.9, 0.0}, {0.02, 0.3, 0.3, 0.0}}, 0.0};
  for (const auto& one : classify(sheet_of(stranger, 0.0, 3), kinds)) {
    EXPECT_LT(one.goodness_p, 1e-3);
  }
}

}  // namespace
}  // namespace hada
