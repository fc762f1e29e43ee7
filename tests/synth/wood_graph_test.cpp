#include "synth/wood_graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/wood_solid.h"
#include "tests/synth/slanted_stem.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 160, .cols = 200, .pitch = 0.1, .unit = Unit::mm};

/// Linear between texels, held at the sides, endless upward, as shader editors do it.
double looked_up(const Grid<float>& picture, double u, double v) {
  const double x = u * picture.cols() - 0.5, y = (1.0 - v) * picture.rows() - 0.5;
  const int col = int(std::floor(x)), row = int(std::floor(y));
  const auto at = [&](int r, int c) {
    const int rows = picture.rows();
    return double(picture((r % rows + rows) % rows, std::clamp(c, 0, picture.cols() - 1)));
  };
  const double right = x - col, down = y - row;
  return (1.0 - down) * ((1.0 - right) * at(row, col) + right * at(row, col + 1)) +
         down * ((1.0 - right) * at(row + 1, col) + right * at(row + 1, col + 1));
}

double mean_difference(const Wood<>& wood, const WoodGraph& graph, Seed seed) {
  const WoodSolid solid(wood, seed);
  const Cut cut = cut_of(wood);
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < extent.rows; row += 3) {
    for (int col = 0; col < extent.cols; col += 3, ++count) {
      const auto place = extent.place(row, col);
      const StemVector at = cut.at(place.x(), place.y());
      const auto values = graph.nodes.values_at(at, [&](const auto& name, double u, double v) {
        return looked_up(graph.pictures.at(name).planes[0], u, v);
      });
      sum += std::abs(values.back() - double(solid.colour_at(solid.place_at(at), 0.05)[0]));
    }
  }
  return sum / count;
}

TEST(WoodGraph, FindsTheColourOfTheSolid) {
  const auto graph = wood_graph(slanted_stem(), extent, 5);
  EXPECT_TRUE(graph.complete);
  // Only where a boundary of rings, 4 mm apart, runs between two texels of 0.05 mm may the colour
  // differ by up to half of 0.36; the picture of leans adds a texel to that.
  EXPECT_LT(mean_difference(slanted_stem(), graph, 5), 0.005);
  // A stem that turns otherwise has another colour: fibres differ by 0.3 of 0.5.
  EXPECT_GT(mean_difference(slanted_stem(), wood_graph(slanted_stem(), extent, 6), 5), 0.01);
  Wood<> straight = slanted_stem();
  straight.spiral = 0.0;
  EXPECT_GT(mean_difference(slanted_stem(), wood_graph(straight, extent, 5), 5), 0.01);
}

TEST(WoodGraph, HasAPictureOfLeansWhereItIsNeeded) {
  EXPECT_EQ(wood_graph(slanted_stem(), extent, 5).pictures.count("lean"), 1u);
  Wood<> plain;
  EXPECT_EQ(wood_graph(plain, extent, 5).pictures.count("lean"), 0u);
}

TEST(WoodGraph, SaysWhatItLeavesOut) {
  Wood<> wobbling;
  wobbling.wobble_mm = 0.5;
  EXPECT_FALSE(wood_graph(wobbling, extent, 5).complete);
}

}  // namespace
}  // namespace hada
