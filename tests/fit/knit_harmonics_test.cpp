#include "fit/knit_harmonics.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Extent extent{60, 80, 0.1, Unit::mm};

Knit<> knit() {
  Knit<> knit;
  knit.wale_mm = 1.1;
  knit.course_mm = 0.9;
  knit.rotation_rad = 0.03;
  return knit;
}

TEST(KnitHarmonics, PackTheLatticeAndUnpackIt) {
  LatticeFields fields;
  fields << 1.0, 2.0, 0.1, 0.2, 0.01, 0.02;
  EXPECT_EQ(lattice_fields(with_lattice_fields(knit(), fields)), fields);
}

TEST(KnitHarmonics, KnowHowPhasesTurnWithTheLattice) {
  const Window window = middle_of(extent, 0.5);
  const auto here = phases_of(knit(), extent, window, 20);
  const LatticeFields at = lattice_fields(knit());
  constexpr double step = 1e-6;
  for (int field = 0; field < lattice_field_count; ++field) {
    LatticeFields moved = at;
    moved[field] += step;
    const auto there = phases_of(with_lattice_fields(knit(), moved), extent, window, 20);
    // A difference quotient of a smooth function: its curvature times the step.
    for (int c = 0; c < window.cols; ++c) {
      EXPECT_NEAR((there.cycles(c, 0) - here.cycles(c, 0)) / step, here.wale_turn(c, field), 1e-4);
      EXPECT_NEAR((there.cycles(c, 1) - here.cycles(c, 1)) / step, here.course_turn(c, field),
                  1e-4);
    }
  }
}

TEST(KnitHarmonics, AreWavesOfTheirNumbers) {
  const Window window = middle_of(extent, 1.0);
  const auto phases = phases_of(knit(), extent, window, 7);
  const auto waves = pattern({{2, -3}}, phases);
  for (int c = 0; c < window.cols; ++c) {
    const auto expected =
        std::polar(1.0, 2.0 * pi * (2.0 * phases.cycles(c, 0) - 3.0 * phases.cycles(c, 1)));
    EXPECT_LT(std::abs(waves(c, 0) - expected), 1e-12);
  }
}

TEST(KnitHarmonics, TheStrongestIsWhatThePictureIsMadeOf) {
  KnitPicture picture{{Grid<float>(60, 80)}, full_mask(extent), extent};
  const Window window = middle_of(extent, 1.0);
  for (int row = 0; row < 60; ++row) {
    const auto phases = phases_of(knit(), extent, window, row);
    for (int c = 0; c < 80; ++c) {
      picture.planes[0](row, c) =
          float(std::cos(2.0 * pi * (phases.cycles(c, 0) + phases.cycles(c, 1))) +
                0.3 * std::cos(2.0 * pi * 2.0 * phases.cycles(c, 1)));
    }
  }
  const auto found = strongest(picture, window, knit(), 1);
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found[0].h, 1);
  EXPECT_EQ(found[0].k, 1);
  EXPECT_EQ(found[1].h, 0);
  EXPECT_EQ(found[1].k, 2);
}

}  // namespace
}  // namespace hada
