#include "reconstruct/shared_terms.h"

#include <vector>

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

// Matte pixels whose normals are known and whose raw samples carry the terms.
Tile tile_with(const SharedTerms& terms, int pixels) {
  const std::vector<Light> lights = ring_of_lights(8);
  Tile tile(int(lights.size()), pixels, false);
  const Tile matte = matte_tile(lights, pixels);
  tile.x_to = matte.x_to;
  tile.y_to = matte.y_to;
  tile.z_to = matte.z_to;
  tile.trust = matte.trust;
  tile.grey = matte.grey;
  for (int i = 0; i < pixels; ++i) {
    const Eigen::Vector3d found = tile_rho * tile_normal(i);
    const auto pixel = std::size_t(i);
    tile.x[pixel] = float(found.x());
    tile.y[pixel] = float(found.y());
    tile.z[pixel] = float(found.z());
  }
  tile.raw.assign(tile.grey.size(), 0.0f);
  std::vector<float> shading;
  shading_of(tile, terms, shading);
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < pixels; ++i) {
      tile.raw[tile.at(k, i)] = float(tile_rho) * shading[tile.at(k, i)];
    }
  }
  return tile;
}

void expect_matte(const Tile& tile) {
  const Tile matte = matte_tile(ring_of_lights(8), tile.pixels);
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < tile.pixels; ++i) {
      // Some ten operations on floats of about 1.
      EXPECT_NEAR(tile.grey[tile.at(k, i)], matte.grey[tile.at(k, i)], 1e-6f);
    }
  }
}

TEST(SharedTerms, ShadeByTheCosineWhereThereAreNone) {
  const Tile tile = tile_with({}, 11);
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < tile.pixels; ++i) {
      EXPECT_NEAR(tile.raw[tile.at(k, i)], tile.grey[tile.at(k, i)], 1e-6f);
    }
  }
}

TEST(SharedTerms, TakeOffTheCurveThatTheyShadeWith) {
  SharedTerms terms;
  terms.curve[0] = -0.3f;
  terms.curve[1] = 0.2f;
  Tile tile = tile_with(terms, 13);
  EXPECT_GT(tile.grey[tile.at(2, 5)] - tile.raw[tile.at(2, 5)], 0.01f);  // it is darker by that
  take_off(tile, terms);
  expect_matte(tile);
}

TEST(SharedTerms, TakeOffWhatLightsAreOff) {
  SharedTerms terms;
  for (int i = 0; i < 24; ++i) terms.off.push_back(0.01f * float(i % 5 - 2));
  Tile tile = tile_with(terms, 9);
  take_off(tile, terms);
  expect_matte(tile);
}

}  // namespace
}  // namespace hada
