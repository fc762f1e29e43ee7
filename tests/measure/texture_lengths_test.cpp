#include "measure/texture_lengths.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "synth/gaussian_field.h"
#include "synth/wrinkle.h"

namespace hada {
namespace {

TEST(TextureLengthsSigma, IsTheScatterOverRealisations) {
  const WrinkleComponent<> component{
      .amplitude_mm = 0.2, .long_mm = 0.8, .short_mm = 0.4, .angle_rad = 0.6};
  const Extent world{.rows = 384, .cols = 384, .pitch = 0.1, .unit = Unit::mm};
  constexpr int seeds = 24;
  double mean = 0.0, squares = 0.0, sigma_squares = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    // A quarter of a field that tiles does not tile.
    const auto field = gaussian_field([&](double fx, double fy) { return psd(component, fx, fy); },
                                      world, Seed(seed));
    const auto height = crop(field, 0, 0, 192, 192);
    const Mask mask(192, 192, 1);
    const auto found = texture_lengths(height, mask);
    mean += found.shortest_px / seeds;
    squares += found.shortest_px * found.shortest_px / seeds;
    const double sigma = texture_lengths_sigma(found, height, mask).shortest_px;
    sigma_squares += sigma * sigma / seeds;
  }
  // The scatter of 24 values is itself known to 1 / sqrt(46) = 15 %; three of those, and the
  // jackknife of 16 blocks is biased upward by as much again.
  const double scatter = std::sqrt((squares - mean * mean) * seeds / (seeds - 1.0));
  EXPECT_GT(std::sqrt(sigma_squares), 0.55 * scatter);
  EXPECT_LT(std::sqrt(sigma_squares), 1.6 * scatter);
}

}  // namespace
}  // namespace hada
