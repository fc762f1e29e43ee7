#include "reconstruct/shared_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

constexpr int pixels = 300;
constexpr double bounced = 0.4;  // coefficient
constexpr double noise = 1e-3;   // of a sample

/// Matte pixels in a light of their neighbours besides, all terms that are to be found in `raw`.
Tile lit_by_neighbours(double coefficient) {
  Tile tile = matte_tile(ring_of_lights(12), pixels);
  tile.weight.assign(tile.grey.size(), 1.0f);
  tile.raw = tile.grey;
  tile.bounce.assign(tile.grey.size(), 0.0f);
  for (int i = 0; i < pixels; ++i) {
    const Eigen::Vector3d scaled = tile_rho * tile_normal(i);
    const auto at = std::size_t(i);
    tile.x[at] = float(scaled.x());
    tile.y[at] = float(scaled.y());
    tile.z[at] = float(scaled.z());
    for (int k = 0; k < tile.lights; ++k) {
      const auto sample = tile.at(k, i);
      tile.bounce[sample] = float(0.1 * uniform(21, i, k));
      tile.grey[sample] += float(noise * gaussian(22, i, k));
      tile.raw[sample] = float(tile.grey[sample] + coefficient * tile.bounce[sample]);
    }
  }
  return tile;
}

SharedModel model_of(const Tile& tile, bool curve, bool bounce) {
  return {curve, bounce, std::vector<double>(std::size_t(tile.lights), 0.003)};
}

TEST(SharedFit, FindsLightThatTheSurfaceThrowsOnItself) {
  const Tile tile = lit_by_neighbours(bounced);
  const SharedFit fit = fit_shared_terms(tile, model_of(tile, false, true));
  // Nine samples in twelve are left over by the unknowns of a pixel; those of `bounce` scatter by
  // 0.1 / sqrt(12). Five deviations.
  const double sigma = noise / (0.1 / std::sqrt(12.0) * std::sqrt(9.0 * pixels));
  EXPECT_NEAR(fit.terms.bounce, bounced, 5.0 * sigma);
  EXPECT_FALSE(fit.terms.curved());
  EXPECT_DOUBLE_EQ(fit.freedom, 9.0 * pixels);
}

TEST(SharedFit, LeavesMoreOverWithoutATermThatIsThere) {
  const Tile tile = lit_by_neighbours(bounced);
  const double with = fit_shared_terms(tile, model_of(tile, false, true)).misfit;
  const double without = fit_shared_terms(tile, model_of(tile, false, false)).misfit;
  // The noise, over its own variance and that of what no model explains, on the one hand; the
  // scatter of the light as well on the other.
  const double deserved = noise * noise + std::pow(unmodelled_share * tile_rho, 2);
  EXPECT_LT(with, 1.1);
  EXPECT_GT(without - with, 0.5 * std::pow(bounced * 0.1, 2) / 12.0 / (2.0 * deserved));
}

TEST(SharedFit, TellsTheCurveOfAMaterial) {
  Tile tile = lit_by_neighbours(0.0);
  const auto curve = [](double cosine) { return 0.2 * (1.0 - cosine); };
  for (int i = 0; i < pixels; ++i) {
    for (int k = 0; k < tile.lights; ++k) {
      const auto light = std::size_t(k);
      const double cosine =
          tile_normal(i).dot(Eigen::Vector3d(tile.x_to[light], tile.y_to[light], tile.z_to[light]));
      tile.raw[tile.at(k, i)] += float(tile_rho * cosine * curve(cosine));
    }
  }
  const SharedTerms terms = fit_shared_terms(tile, model_of(tile, true, false)).terms;
  // Lights stand at 45 and 60 degrees. What the albedo can take is open, the slope is not: its
  // sigma is that of a straight line in the cosine, whose deviation is 0.13 over these pixels,
  // with another four for what lights that are off can take.
  const auto found = [&](double cosine) {
    const double away = 1.0 - cosine;
    return away * (terms.curve[0] + away * (terms.curve[1] + away * terms.curve[2]));
  };
  const double sigma = noise / (tile_rho * 0.7 * 0.13 * std::sqrt(9.0 * pixels));
  EXPECT_NEAR((found(0.6) - found(0.85)) / 0.25, 0.2, 5.0 * 4.0 * sigma);
  EXPECT_EQ(terms.bounce, 0.0f);
}

TEST(SharedFit, DoesNotCountPixelsWithoutANormal) {
  Tile tile = lit_by_neighbours(bounced);
  tile.x[0] = tile.y[0] = tile.z[0] = 0.0f;
  EXPECT_DOUBLE_EQ(fit_shared_terms(tile, model_of(tile, false, true)).freedom, 9.0 * (pixels - 1));
}

}  // namespace
}  // namespace hada
