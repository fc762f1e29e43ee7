#include "reconstruct/least_squares.h"

#include <algorithm>
#include <cstddef>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

template <bool near>
[[gnu::always_inline]] inline void fit(Tile& tile) {
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    NormalEquations sums;
    for (int k = 0; k < tile.lights; ++k) {
      const Lanes trust = block.trust(k);
      sums.add(trust, block.to_light(k), block.grey(k));
      store(&tile.weight[tile.at(k, first)], trust);
    }
    const Inverse inverse(sums);
    Lanes3 found = inverse * sums.right;
    Lanes3 left{};  // once more on the residuals: takes rounding off
    for (int k = 0; k < tile.lights; ++k) {
      const Lanes r = block.trust(k) * residual(block, k, found);
      const Lanes3 l = block.to_light(k);
      left.x += l.x * r;
      left.y += l.y * r;
      left.z += l.z * r;
    }
    const Lanes3 step = inverse * left;
    found.x += step.x;
    found.y += step.y;
    found.z += step.z;
    store(tile, first, found);
  }
}

// As `Block` of distant lights, but where the samples lie in the pictures.
struct PictureBlock {
  const GreyRows& rows;
  int first;

  [[gnu::always_inline]] Lanes grey(int k) const {
    const auto light = std::size_t(k);
    return all(rows.scale[light]) * load(rows.values[light] + first);
  }
};

struct Matrix {
  const float* to_x;
  const float* to_y;
  const float* to_z;

  Matrix(const std::vector<float>& rows, int lights)
      : to_x(rows.data()), to_y(to_x + lights), to_z(to_y + lights) {}

  template <class Source>
  [[gnu::always_inline]] void add(const Source& block, int k, Lanes3& found) const {
    const Lanes grey = block.grey(k);
    found.x += all(to_x[k]) * grey;
    found.y += all(to_y[k]) * grey;
    found.z += all(to_z[k]) * grey;
  }
};

[[gnu::always_inline]] inline void multiply(Tile& tile, const std::vector<float>& pseudo_inverse) {
  const Matrix matrix(pseudo_inverse, tile.lights);
  for (int first = 0; first < tile.pixels; first += lane_count) {
    Lanes3 found{};
    for (int k = 0; k < tile.lights; ++k) matrix.add(Block<false>{tile, first}, k, found);
    store(tile, first, found);
  }
}

// Whole cache lines at once: planes often lie a multiple of 4096 bytes apart, so that a line is
// soon displaced by those of the other lights. For the same reason, and for the ends of pages, the
// processor does not fetch ahead well on its own.
constexpr int line_pixels = 16;
constexpr int fetch_ahead = 256;

[[gnu::always_inline]] inline void multiply(const GreyRows& rows, int count,
                                            const std::vector<float>& pseudo_inverse, Tile& tile) {
  const Matrix matrix(pseudo_inverse, tile.lights);
  int first = 0;
  for (; first + line_pixels <= count; first += line_pixels) {
    Lanes3 left{}, right{};
    for (int k = 0; k < tile.lights; ++k) {
      __builtin_prefetch(rows.values[std::size_t(k)] + first + fetch_ahead, 0, 2);
      matrix.add(PictureBlock{rows, first}, k, left);
      matrix.add(PictureBlock{rows, first + lane_count}, k, right);
    }
    store(tile, first, left);
    store(tile, first + lane_count, right);
  }
  while (first < count) {
    first = std::min(first, count - lane_count);  // the last eight may be solved twice
    Lanes3 found{};
    for (int k = 0; k < tile.lights; ++k) matrix.add(PictureBlock{rows, first}, k, found);
    store(tile, first, found);
    first += lane_count;
  }
}

}  // namespace

HADA_CLONES_AVX2 void fit_least_squares(Tile& tile) {
  if (tile.near) {
    fit<true>(tile);
  } else {
    fit<false>(tile);
  }
}

HADA_CLONES_AVX2 void fit_pseudo_inverse(Tile& tile, const std::vector<float>& pseudo_inverse) {
  multiply(tile, pseudo_inverse);
}

HADA_CLONES_AVX2 void fit_pseudo_inverse(const GreyRows& rows, int count,
                                         const std::vector<float>& pseudo_inverse, Tile& tile) {
  multiply(rows, count, pseudo_inverse, tile);
}

}  // namespace hada
