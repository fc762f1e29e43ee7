#include "fit/observe.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "measure/response.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

// White height noise: its spectrum is known and reaches to Nyquist.
Surface white_surface() {
  Surface surface;
  surface.extent = {.rows = 128, .cols = 128, .pitch = 0.2, .unit = Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.height = gaussian_field([](double, double) { return 1e-6; }, surface.extent, 4);
  return surface;
}

double total(const std::vector<Cell>& cells, double Cell::*value) {
  double sum = 0.0;
  for (const Cell& cell : cells) sum += cell.*value * cell.count;
  return sum;
}

TEST(Observe, GivesBackWhatPhotographsTook) {
  Surface surface = white_surface();
  const auto plain = observe(surface);
  surface.normal_sigma = Grid<float>(128, 128, 1e-9f);
  const auto photographed = observe(surface);
  const double fx = plain.spectrum.fx(20);
  const double amplitude = photographed_amplitude(fx, 0.0, 0.2);
  EXPECT_NEAR(photographed.spectrum.power(0, 20) * amplitude * amplitude,
              plain.spectrum.power(0, 20), 1e-9 * plain.spectrum.power(0, 20));
  EXPECT_EQ(total(plain.fine, &Cell::noise), 0.0);
}

TEST(Observe, GivesBackWhatALensTook) {
  const Surface surface = white_surface();
  const auto plain = observe(surface);
  const auto known = observe(surface, 1.0);
  const double f = plain.spectrum.fx(12) * 0.2;  // cycles per pixel
  const double left = std::exp(-std::pow(2.0 * std::numbers::pi * f, 2));
  EXPECT_NEAR(known.spectrum.power(0, 12) * left, plain.spectrum.power(0, 12),
              1e-9 * plain.spectrum.power(0, 12));
  // And no cell lies where less than a third of the power was left.
  for (const Cell& cell : known.full) {
    EXPECT_LT(std::hypot(cell.fx, cell.fy) * 0.2,
              std::sqrt(std::log(3.0)) / (2.0 * std::numbers::pi) + 1e-12);
  }
}

TEST(Observe, BelievesNoMoreNoiseThanTheNormalsAdmit) {
  Surface surface = white_surface();
  double before = 0.0;
  for (const float sigma : {0.001f, 0.002f}) {
    surface.normal_sigma = Grid<float>(128, 128, sigma);
    const double noise = total(observe(surface).fine, &Cell::noise);
    // Twice the sigma, four times the power, while the fast waves hold more than that.
    if (before > 0.0) {
      EXPECT_NEAR(noise / before, 4.0, 1e-4);
    }
    before = noise;
  }
  // A sigma beyond all that the fast waves hold is not believed.
  surface.normal_sigma = Grid<float>(128, 128, 10.0f);
  const auto cells = observe(surface).full;
  EXPECT_LT(total(cells, &Cell::noise), 1e3 * total(cells, &Cell::power));
}

TEST(Observe, RefusesAFlatMapAndASmallOne) {
  Surface flat = white_surface();
  flat.height = Grid<float>(128, 128, 0.0f);
  EXPECT_THROW(observe(flat), Error);
  Surface small = white_surface();
  small.extent = {.rows = 20, .cols = 20, .pitch = 0.2, .unit = Unit::mm};
  small.mask = full_mask(small.extent);
  small.height = Grid<float>(20, 20, 1.0f);
  EXPECT_THROW(observe(small), Error);
}

}  // namespace
}  // namespace hada
