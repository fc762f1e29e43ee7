#include "reconstruct/unit_normals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr float least_z = 0.02f;

template <bool aligned>
[[gnu::always_inline]] inline void write(float* to, const Lanes& lanes) {
  if constexpr (aligned) {
    store_past_caches(to, lanes);
  } else {
    store(to, lanes);
  }
}

// Eight vectors, x, y, z of one after another. Shuffles stay within halves of four pixels, which
// costs one step, until the halves are put in order.
template <bool aligned>
[[gnu::always_inline]] inline void interleave(const Lanes3& v, float* out) {
  const Lanes xy = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 1, 4, 12, 5, 5);
  const Lanes yz = __builtin_shufflevector(v.y, v.z, 1, 9, 2, 2, 5, 13, 6, 6);
  const Lanes zx = __builtin_shufflevector(v.z, v.x, 2, 11, 3, 3, 6, 15, 7, 7);
  const Lanes xyzx = __builtin_shufflevector(
      xy, __builtin_shufflevector(v.z, v.x, 0, 9, 0, 0, 4, 13, 4, 4), 0, 1, 8, 9, 4, 5, 12, 13);
  const Lanes yzxy = __builtin_shufflevector(
      yz, __builtin_shufflevector(v.x, v.y, 2, 10, 2, 2, 6, 14, 6, 6), 0, 1, 8, 9, 4, 5, 12, 13);
  const Lanes zxyz = __builtin_shufflevector(
      zx, __builtin_shufflevector(v.y, v.z, 3, 11, 3, 3, 7, 15, 7, 7), 0, 1, 8, 9, 4, 5, 12, 13);
  write<aligned>(out, __builtin_shufflevector(xyzx, yzxy, 0, 1, 2, 3, 8, 9, 10, 11));
  write<aligned>(out + lane_count, __builtin_shufflevector(zxyz, xyzx, 0, 1, 2, 3, 12, 13, 14, 15));
  write<aligned>(out + 2 * lane_count,
                 __builtin_shufflevector(yzxy, zxyz, 4, 5, 6, 7, 12, 13, 14, 15));
}

template <bool aligned>
[[gnu::always_inline]] inline void split(const Lanes3& found, const NormalOutput& out) {
  const Lanes rho = root(dot(found, found));
  const LaneBits good = (found.z > all(least_z) * rho) & (rho < all(beyond_all));
  const LaneBits valid = good & load_flags(out.mask);
  const Lanes scale = all(1.0f) / chosen(good, rho, all(1.0f));
  const Lanes none{};
  interleave<aligned>({chosen(valid, found.x * scale, none), chosen(valid, found.y * scale, none),
                       chosen(valid, found.z * scale, all(1.0f))},
                      out.normals);
  write<aligned>(out.rho, chosen(good, rho, none));
  store_flags(out.mask, valid);
}

[[gnu::always_inline]] inline Lanes3 found_at(const Tile& tile, std::size_t pixel) {
  return {load(&tile.x[pixel]), load(&tile.y[pixel]), load(&tile.z[pixel])};
}

// The first and last pixels of a row share their eight lanes with memory that is not theirs.
[[gnu::always_inline]] inline void split_rest(const Tile& tile, std::size_t pixel, int count,
                                              const NormalOutput& out) {
  float found[3][lane_count] = {};
  float normals[3 * lane_count], rho[lane_count];
  std::uint8_t mask[lane_count] = {};
  std::copy_n(&tile.x[pixel], count, found[0]);
  std::copy_n(&tile.y[pixel], count, found[1]);
  std::copy_n(&tile.z[pixel], count, found[2]);
  std::copy_n(out.mask, count, mask);
  split<false>({load(found[0]), load(found[1]), load(found[2])}, {normals, rho, mask});
  std::copy_n(normals, 3 * count, out.normals);
  std::copy_n(rho, count, out.rho);
  std::copy_n(mask, count, out.mask);
}

// Pixels before the first one whose normal and albedo both begin a vector in memory; all of them
// where there is none.
[[gnu::always_inline]] inline int before_aligned(int count, const NormalOutput& out) {
  const auto begins = [](const float* place) {
    return reinterpret_cast<std::uintptr_t>(place) % sizeof(Lanes) == 0;
  };
  for (int i = 0; i < std::min(count, lane_count); ++i) {
    if (begins(out.normals + 3 * i) && begins(out.rho + i)) return i;
  }
  return count;
}

template <bool aligned>
[[gnu::always_inline]] inline void put(const Tile& tile, int first, int count,
                                       const NormalOutput& output) {
  const auto from = [&](int i) {
    return NormalOutput{output.normals + 3 * i, output.rho + i, output.mask + i};
  };
  int i = 0;
  for (; i + lane_count <= count; i += lane_count) {
    split<aligned>(found_at(tile, std::size_t(first + i)), from(i));
  }
  if (i < count) split_rest(tile, std::size_t(first + i), count - i, from(i));
}

}  // namespace

HADA_CLONES_AVX2 void put_unit_normals(const Tile& tile, int first, int count,
                                       const NormalOutput& output) {
  const int head = before_aligned(count, output);
  put<false>(tile, first, head, output);
  if (head == count) return;
  put<true>(tile, first + head, count - head,
            {output.normals + 3 * head, output.rho + head, output.mask + head});
  finish_stores();
}

}  // namespace hada
