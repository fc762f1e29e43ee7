#include "synth/blade.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Blade, IsClosedAndSeenFromOutside) {
  const auto mesh = blade_mesh({});
  // Vertices lie twice along edge and back: edges are compared by place.
  using Place = std::tuple<double, double, double>;
  std::map<std::pair<Place, Place>, int> edges;
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& a = mesh.vertices_mm[std::size_t(t[k])];
      const auto& b = mesh.vertices_mm[std::size_t(t[(k + 1) % 3])];
      const Place from{a.x(), a.y(), std::abs(a.z()) < 1e-12 ? 0.0 : a.z()};
      const Place to{b.x(), b.y(), std::abs(b.z()) < 1e-12 ? 0.0 : b.z()};
      ++edges[{from, to}];
      --edges[{to, from}];
    }
    volume += mesh.vertices_mm[std::size_t(t[0])].dot(
                  mesh.vertices_mm[std::size_t(t[1])].cross(mesh.vertices_mm[std::size_t(t[2])])) /
              6.0;
  }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
  // A blade of 700 mm, 26 mm wide and 6 mm thick on average, three quarters full: 80000 mm^3.
  EXPECT_GT(volume, 60000.0);
  EXPECT_LT(volume, 120000.0);
}

TEST(Blade, IsCurvedAndTapered) {
  const auto mesh = blade_mesh({.curvature_mm = 20.0});
  double low = 1e9, high = -1e9;
  for (std::size_t k = 0; k < mesh.vertices_mm.size(); ++k) {
    if (mesh.uv[k].y() != 1.0) continue;
    low = std::min(low, mesh.vertices_mm[k].y());
    high = std::max(high, mesh.vertices_mm[k].y());
  }
  EXPECT_NEAR(high - low, 20.0, 1e-9);  // the back is a parabola, highest at its ends
  ASSERT_EQ(mesh.uv.size(), mesh.vertices_mm.size());
  for (const auto& uv : mesh.uv) {
    EXPECT_GE(uv.minCoeff(), 0.0);
    EXPECT_LE(uv.maxCoeff(), 1.0);
  }
}

TEST(Blade, HasItsHamonAlongTheEdge) {
  const auto mask = hamon_mask(100, 800, {.height = 0.3, .wave = 0.05, .mist = 0.02}, 3);
  double sum = 0.0;
  for (int col = 0; col < 800; ++col) {
    EXPECT_LT(mask(0, col), 0.01f);   // the back
    EXPECT_GT(mask(99, col), 0.99f);  // the edge
    for (int row = 0; row < 100; ++row) sum += mask(row, col);
  }
  // Waves of 5 % about 30 %, whose mean over 24 of them is off by less than a fifth of that.
  EXPECT_NEAR(sum / 80000.0, 0.3, 0.01);
  EXPECT_EQ(hamon_mask(4, 4, {.height = 0.0}, 1), Grid<float>(4, 4));
}

TEST(Ayasugi, BendsStraightGrainIntoWaves) {
  Grid<float> lines(256, 400);
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 400; ++col) lines(row, col) = std::sin(0.2f * float(row));
  }
  const auto waved = ayasugi(lines, {.wavelength = 100.0, .amplitude = 12.0});
  // Bilinear between rows: an error of 0.2^2 / 8 at most.
  for (const int col : {0, 20, 50, 130}) {
    const double shift = 12.0 * std::cos(2.0 * 3.14159265358979 * col / 100.0);
    EXPECT_NEAR(waved(100, col), std::sin(0.2 * (100.0 + shift)), 0.006);
  }
  EXPECT_EQ(ayasugi(lines, {}), lines);
  const auto twisted = ayasugi(lines, {.wavelength = 100.0, .amplitude = 12.0, .twisted = true});
  EXPECT_EQ(twisted.row(9)[0], lines(9, 0));  // between two turns nothing moves
  EXPECT_NE(twisted, waved);
}

}  // namespace
}  // namespace hada
