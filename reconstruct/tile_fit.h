#pragma once

#include <limits>

#include "reconstruct/lanes.h"
#include "reconstruct/tile.h"

/// What the estimators share: weighted least squares for the three unknowns of eight pixels.
namespace hada {

/// A vector in space, for eight pixels.
struct Lanes3 {
  Lanes x, y, z;
};

[[gnu::always_inline]] inline Lanes dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The eight pixels of a tile that begin at `first`.
template <bool near>
struct Block {
  const Tile& tile;
  int first;

  [[gnu::always_inline]] Lanes grey(int k) const { return load(&tile.grey[tile.at(k, first)]); }
  [[gnu::always_inline]] Lanes trust(int k) const { return load(&tile.trust[tile.at(k, first)]); }
  [[gnu::always_inline]] Lanes3 found() const {
    const auto i = std::size_t(first);
    return {load(&tile.x[i]), load(&tile.y[i]), load(&tile.z[i])};
  }
  [[gnu::always_inline]] Lanes3 to_light(int k) const {
    if constexpr (near) {
      const std::size_t i = tile.at(k, first);
      return {load(&tile.x_to[i]), load(&tile.y_to[i]), load(&tile.z_to[i])};
    } else {
      const auto i = std::size_t(k);
      return {all(tile.x_to[i]), all(tile.y_to[i]), all(tile.z_to[i])};
    }
  }
};

/// The normal equations sum w l l^T (step) = sum w l value.
struct NormalEquations {
  Lanes xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  Lanes3 right{};

  [[gnu::always_inline]] inline void add(const Lanes& weight, const Lanes3& l, const Lanes& value) {
    const Lanes3 w{weight * l.x, weight * l.y, weight * l.z};
    xx += w.x * l.x;
    xy += w.x * l.y;
    xz += w.x * l.z;
    yy += w.y * l.y;
    yz += w.y * l.z;
    zz += w.z * l.z;
    right.x += w.x * value;
    right.y += w.y * value;
    right.z += w.z * value;
  }
};

/// The inverse of the matrix of normal equations; 0 where the lights lie near one plane.
struct Inverse {
  Lanes xx, xy, xz, yy, yz, zz;

  /// The smallest singular value of the directions over the largest, below which they count as
  /// lying in one plane: there a noise of 1 % of the albedo turns the normal by half a radian.
  static constexpr float least_spread = 0.02f;

  [[gnu::always_inline]] explicit Inverse(const NormalEquations& m)
      : xx(m.yy * m.zz - m.yz * m.yz),
        xy(m.xz * m.yz - m.xy * m.zz),
        xz(m.xy * m.yz - m.xz * m.yy),
        yy(m.xx * m.zz - m.xz * m.xz),
        yz(m.xy * m.xz - m.xx * m.yz),
        zz(m.xx * m.yy - m.xy * m.xy) {
    const Lanes determinant = m.xx * xx + m.xy * xy + m.xz * xz;
    // The product of all eigenvalues over that of the two largest is the smallest, nearly.
    const Lanes pairs = xx + yy + zz;
    const Lanes sum = m.xx + m.yy + m.zz;
    // Of a single direction the pairs are rounding, of either sign.
    const LaneBits solvable = (pairs > all(least_spread * least_spread) * sum * sum) &
                              (determinant > all(least_spread * least_spread) * sum * pairs);
    const Lanes scale =
        chosen(solvable, all(1.0f), all(0.0f)) / chosen(solvable, determinant, all(1.0f));
    xx *= scale;
    xy *= scale;
    xz *= scale;
    yy *= scale;
    yz *= scale;
    zz *= scale;
  }

  [[gnu::always_inline]] Lanes3 operator*(const Lanes3& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
            xz * v.x + yz * v.y + zz * v.z};
  }
};

/// Sorts `count` vectors at `values`, lane by lane.
[[gnu::always_inline]] inline void sort(const Tile& tile, float* values) {
  for (const auto& [low, high] : tile.network) {
    const Lanes a = load(values + low * lane_count);
    const Lanes b = load(values + high * lane_count);
    store(values + low * lane_count, smaller(a, b));
    store(values + high * lane_count, larger(a, b));
  }
}

/// Of sorted vectors, in each lane the one of this rank.
[[gnu::always_inline]] inline Lanes at_rank(const float* sorted, const LaneBits& rank) {
  Lanes result;
  for (int i = 0; i < lane_count; ++i) result[i] = sorted[rank[i] * lane_count + i];
  return result;
}

inline constexpr float beyond_all = std::numeric_limits<float>::max();

/// How many samples of each pixel may count.
template <bool near>
[[gnu::always_inline]] inline LaneBits trusted(const Block<near>& block) {
  LaneBits count{};
  for (int k = 0; k < block.tile.lights; ++k) count -= block.trust(k) > all(0.0f);
  return count;
}

/// Sorted grey values at `out`, those that may not count last.
template <bool near>
[[gnu::always_inline]] inline void sorted_greys(const Block<near>& block, float* out) {
  for (int k = 0; k < block.tile.lights; ++k) {
    store(out + k * lane_count, chosen(block.trust(k) > all(0.0f), block.grey(k), all(beyond_all)));
  }
  sort(block.tile, out);
}

/// Least squares over the samples that may count and lie between two grey values.
template <bool near>
[[gnu::always_inline]] inline Lanes3 fit_between(const Block<near>& block, const Lanes& low,
                                                 const Lanes& high) {
  NormalEquations sums;
  for (int k = 0; k < block.tile.lights; ++k) {
    const Lanes grey = block.grey(k);
    const LaneBits inside = (grey >= low) & (grey <= high);
    sums.add(chosen(inside, block.trust(k), all(0.0f)), block.to_light(k), grey);
  }
  return Inverse(sums) * sums.right;
}

/// No sample is believed to be better than this: its noise, and what no model explains.
[[gnu::always_inline]] inline Lanes least_variance(const Tile& tile, const Lanes3& found) {
  const Lanes squares = dot(found, found);
  return all(tile.noise.constant) + all(tile.noise.shot) * root(squares) +
         all(unmodelled_share * unmodelled_share) * squares + all(1e-12f);
}

[[gnu::always_inline]] inline Lanes least_sigma(const Tile& tile, const Lanes3& found) {
  return root(least_variance(tile, found));
}

template <bool near>
[[gnu::always_inline]] inline Lanes residual(const Block<near>& block, int k, const Lanes3& found) {
  return block.grey(k) - dot(block.to_light(k), found);
}

[[gnu::always_inline]] inline void store(Tile& tile, int first, const Lanes3& found) {
  store(&tile.x[std::size_t(first)], found.x);
  store(&tile.y[std::size_t(first)], found.y);
  store(&tile.z[std::size_t(first)], found.z);
}

}  // namespace hada
