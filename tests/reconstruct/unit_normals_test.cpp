#include "reconstruct/unit_normals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

struct Output {
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> rho;
  std::vector<std::uint8_t> mask;

  // One pixel more than is asked for, which must stay as it is.
  explicit Output(int count)
      : normals(std::size_t(count) + 1, Eigen::Vector3f(7.0f, 7.0f, 7.0f)),
        rho(std::size_t(count) + 1, 7.0f),
        mask(std::size_t(count) + 1, 1) {}

  NormalOutput place() { return {normals[0].data(), rho.data(), mask.data()}; }
};

Tile answers(int pixels) {
  Tile tile(3, pixels, false);
  for (int i = 0; i < pixels; ++i) {
    const auto pixel = std::size_t(i);
    tile.x[pixel] = float(tile_rho * tile_normal(i).x());
    tile.y[pixel] = float(tile_rho * tile_normal(i).y());
    tile.z[pixel] = float(tile_rho * tile_normal(i).z());
  }
  return tile;
}

TEST(PutUnitNormals, SplitTheAlbedoOffAnyNumberOfPixels) {
  const int first = 3;
  const Tile tile = answers(40);
  for (const int count : {1, 7, 8, 9, 16, 29}) {
    Output out(count);
    put_unit_normals(tile, first, count, out.place());
    for (int i = 0; i < count; ++i) {
      const auto pixel = std::size_t(i);
      // A handful of roundings of 6e-8 each.
      EXPECT_LT((out.normals[pixel].cast<double>() - tile_normal(first + i)).norm(), 3e-7);
      EXPECT_NEAR(out.rho[pixel], tile_rho, 3e-7);
      EXPECT_EQ(out.mask[pixel], 1);
    }
    EXPECT_EQ(out.normals[std::size_t(count)], Eigen::Vector3f(7.0f, 7.0f, 7.0f));
    EXPECT_EQ(out.rho[std::size_t(count)], 7.0f);
  }
}

// Wherever the output lies, and so whichever way it is written, it is the same.
TEST(PutUnitNormals, GiveTheSameBytesAnywhereInMemory) {
  constexpr int count = 37;
  const Tile tile = answers(count);
  Output expected(count);
  put_unit_normals(tile, 0, count, expected.place());
  Output out(count + 40);
  for (int at = 0; at < 32; ++at) {
    std::fill(out.normals.begin(), out.normals.end(), Eigen::Vector3f(7.0f, 7.0f, 7.0f));
    std::fill(out.rho.begin(), out.rho.end(), 7.0f);
    // At some places normals and albedo begin a vector together, at others never.
    const auto pixel = std::size_t(at);
    const std::size_t rho = pixel % 5 == 0 ? pixel : pixel % 7;
    put_unit_normals(tile, 0, count, {out.normals[pixel].data(), &out.rho[rho], out.mask.data()});
    for (std::size_t i = 0; i <= count; ++i) {
      EXPECT_EQ(out.normals[pixel + i], expected.normals[i]) << at;
      EXPECT_EQ(out.rho[rho + i], expected.rho[i]) << at;
    }
  }
}

TEST(PutUnitNormals, TakePixelsWithoutAnAnswerOutOfTheMask) {
  Tile tile = answers(16);
  tile.x[2] = tile.y[2] = tile.z[2] = 0.0f;
  tile.x[5] = 0.5f;
  tile.y[5] = 0.0f;
  tile.z[5] = 0.009f;  // 89 degrees
  tile.z[11] = -0.3f;
  Output out(16);
  out.mask[7] = 0;
  put_unit_normals(tile, 0, 16, out.place());
  for (std::size_t i = 0; i < 16; ++i) {
    const bool unsolved = i == 2 || i == 5 || i == 11;
    EXPECT_EQ(out.mask[i], !unsolved && i != 7) << i;
    EXPECT_EQ(out.rho[i] == 0.0f, unsolved) << i;
    EXPECT_EQ(out.normals[i] == Eigen::Vector3f::UnitZ(), !out.mask[i]) << i;
  }
}

}  // namespace
}  // namespace hada
