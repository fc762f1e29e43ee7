#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace hada {

inline constexpr int lane_count = 8;  // pixels that are computed at once

/// No sample is explained better than this, as a share of the albedo: no surface is Lambertian
/// beyond that, nor are its pixels flat.
inline constexpr float unmodelled_share = 0.002f;

/// The variance of a sample that is to be expected at a pixel of albedo rho: constant + shot * rho.
struct NoiseLaw {
  float constant = 0.0f;
  float shot = 0.0f;
};

/// Pixels that are solved together, their samples laid out so that neighbours are loaded at once.
///
/// Values of light k at pixel i lie at [k * stride + i]; `stride` is `pixels` rounded up to whole
/// vectors, and what lies beyond `pixels` is computed and ignored.
struct Tile {
  int lights = 0;
  int pixels = 0;
  int stride = 0;
  bool near = false;                    // each pixel has directions of its own
  std::vector<float> grey;              // strength and fall-off divided out
  std::vector<float> trust;             // 1, or 0 for a sample that must not count
  std::vector<float> x_to, y_to, z_to;  // unit, towards light k: [k], or near [k * stride + i]
  bool trusts_all = false;              // `trust` is 1 throughout
  bool weighs_all = false;              // `weight` is 1 throughout
  std::vector<float> closeness;  // near: distance of the light to the origin over that to the point
  std::vector<float> raw;        // `grey` before what all pixels share was taken off, or empty
  std::vector<float> bounce;     // light from other parts of the surface, or empty
  NoiseLaw noise;

  std::vector<float> x, y, z;                // [i]: albedo times normal, found; 0 where unsolvable
  std::vector<float> weight;                 // how much each sample counted in the end, 0 to 1
  std::vector<float> scratch;                // 2 * lights vectors
  std::vector<std::pair<int, int>> network;  // comparisons that sort `lights` values

  Tile(int light_count, int most_pixels, bool near_lights);

  std::size_t at(int light, int pixel) const {
    return std::size_t(light) * std::size_t(stride) + std::size_t(pixel);
  }
};

/// Pixels of one row in all pictures, where they lie: the grey value of light k at pixel i is
/// scale[k] * values[k][i].
struct GreyRows {
  std::vector<const float*> values;
  std::vector<float> scale;
};

/// Compare-and-swap steps that sort any `count` values (K. E. Batcher, Sorting networks and their
/// applications, AFIPS 1968: odd-even merge sort).
std::vector<std::pair<int, int>> sorting_network(int count);

}  // namespace hada
