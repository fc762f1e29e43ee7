#include "reconstruct/row_kernels.h"

#include <cstring>

#include "reconstruct/clones.h"
#include "reconstruct/dealt.h"
#include "reconstruct/lanes.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wunknown-pragmas"  // those of GCC below
#endif

namespace hada::row_kernels {
namespace {

constexpr float twelfth = 1.0f / 12.0f;  // times 12, 6, 4 and 3 it rounds to what it should be

inline float inverse_of(std::uint8_t code) {
  return float(code >> 4) * twelfth;
}

constexpr int together = Dealt::together;

// Whether 16 bytes all have the value.
inline bool all_are(const std::uint8_t* bytes, std::uint8_t value) {
  std::uint64_t parts[2];
  std::memcpy(parts, bytes, sizeof parts);
  const std::uint64_t wanted = 0x0101010101010101u * value;
  return ((parts[0] ^ wanted) | (parts[1] ^ wanted)) == 0;
}

// special(i) for 16 cells that all have the mark, general(i) for all others.
template <class Special, class General>
[[gnu::always_inline]] inline void for_marked(int n, const std::uint8_t* marks, std::uint8_t mark,
                                              const Special& special, const General& general) {
  int first = 0;
  for (; marks && first + together <= n; first += together) {
    if (all_are(marks + first, mark)) {
#pragma GCC ivdep
      for (int i = first; i < first + together; ++i) special(i);
    } else {
#pragma GCC ivdep
      for (int i = first; i < first + together; ++i) general(i);
    }
  }
#pragma GCC ivdep
  for (int i = first; i < n; ++i) general(i);
}

// put(i, the step to the value at which the equation of cell i holds). Where nothing is missing
// around it, from differences: however large x is, they hardly round.
template <class Put>
[[gnu::always_inline]] inline void for_steps(int n, const float* x, const Around& value,
                                             const float* right, const std::uint8_t* code,
                                             const Put& put) {
  const float *const up = value.up, *const down = value.down;
  const float *const left = value.left, *const beyond = value.right;
  for_marked(
      n, code, edge_code(4),
      [=](int i) {
        const float here = x[i];
        put(i, 0.25f * (right[i] + (((up[i] - here) + (down[i] - here)) +
                                    ((left[i] - here) + (beyond[i] - here)))));
      },
      [=](int i) {
        const float sum = right[i] + ((up[i] + down[i]) + (left[i] + beyond[i]));
        put(i, sum * inverse_of(code[i]) - x[i]);
      });
}

template <class Put>
[[gnu::always_inline]] inline void for_relaxed(int n, const Around& value, const Around& weight,
                                               const float* right, const float* inverse,
                                               const std::uint8_t* even, const Put& put) {
  const float *const up = value.up, *const down = value.down;
  const float *const left = value.left, *const beyond = value.right;
  const float *const wu = weight.up, *const wd = weight.down;
  const float *const wl = weight.left, *const wr = weight.right;
  for_marked(
      n, even, 1,
      [=](int i) { put(i, (right[i] + ((up[i] + down[i]) + (left[i] + beyond[i]))) * 0.25f); },
      [=](int i) {
        const float sum = (wu[i] * up[i] + wd[i] * down[i]) + (wl[i] * left[i] + wr[i] * beyond[i]);
        put(i, (right[i] + sum) * inverse[i]);
      });
}

// Eight coarse cells from i on, each carried to its corner, as `add_carried` tells.
[[gnu::always_inline]] inline Lanes carried_evenly(const Corner& corner, int i) {
  const Lanes value = load(corner.value + i);
  return value + 0.25f * (load(corner.across + i) - value) +
         0.25f * (load(corner.along + i) - value);
}

[[gnu::always_inline]] inline Lanes carried(const Corner& corner, int i) {
  const Lanes value = load(corner.value + i);
  const Lanes f = load(corner.across_weight + i) * load(corner.across_reach + i);
  const Lanes g = load(corner.along_weight + i) * load(corner.along_reach + i);
  return value + smaller(f, all(0.5f)) * (load(corner.across + i) - value) +
         smaller(g, all(0.5f)) * (load(corner.along + i) - value);
}

inline bool eight_are_even(const Corner& corner, int i) {
  std::uint64_t marks;
  std::memcpy(&marks, corner.even + i, sizeof marks);
  return marks == 0x0101010101010101u;
}

// alive(place): which of eight fine cells there are.
template <class Alive>
[[gnu::always_inline]] inline void add_eights(int n, float factor, float* __restrict x,
                                              const Corner& even, const Corner& odd,
                                              const Alive& alive) {
  for (int i = 0; i < n; i += lane_count) {
    const bool plain = even.even && eight_are_even(even, i) && eight_are_even(odd, i);
    const Lanes a = plain ? carried_evenly(even, i) : carried(even, i);
    const Lanes b = plain ? carried_evenly(odd, i) : carried(odd, i);
    Lanes first = __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
    Lanes second = __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
    float* const to = x + 2 * i;
    first = load(to) + factor * first;
    second = load(to + lane_count) + factor * second;
    // All fine cells of an even one are there.
    store(to, plain ? first : chosen(alive(2 * i), first, all(0.0f)));
    store(to + lane_count, plain ? second : chosen(alive(2 * i + lane_count), second, all(0.0f)));
  }
}

}  // namespace

HADA_CLONES_AVX512 void relax(int n, float magic, float* __restrict x, const Around& value,
                              const float* right, const std::uint8_t* code) {
  for_steps(n, x, value, right, code,
            [=](int i, float step) { x[i] = ((x[i] + step) + magic) - magic; });
}

HADA_CLONES_AVX512 void relax(int n, float* __restrict x, const Around& value, const Around& weight,
                              const float* right, const float* inverse, const std::uint8_t* even) {
  for_relaxed(n, value, weight, right, inverse, even,
              [=](int i, float relaxed) { x[i] = relaxed; });
}

HADA_CLONES_AVX512 void over_relax(int n, float factor, float magic, float* __restrict x,
                                   const Around& value, const float* right,
                                   const std::uint8_t* code) {
  for_steps(n, x, value, right, code,
            [=](int i, float step) { x[i] = ((x[i] + factor * step) + magic) - magic; });
}

HADA_CLONES_AVX512 void over_relax(int n, float factor, float* __restrict x, const Around& value,
                                   const Around& weight, const float* right, const float* inverse,
                                   const std::uint8_t* even) {
  for_relaxed(n, value, weight, right, inverse, even,
              [=](int i, float relaxed) { x[i] += factor * (relaxed - x[i]); });
}

HADA_CLONES_AVX512 void relax_from_zero(int n, float factor, float* __restrict x,
                                        const float* right, const std::uint8_t* code) {
  for (int i = 0; i < n; ++i) x[i] = factor * (right[i] * inverse_of(code[i]));
}

HADA_CLONES_AVX512 void relax_from_zero(int n, float factor, float* __restrict x,
                                        const float* right, const float* inverse) {
  for (int i = 0; i < n; ++i) x[i] = factor * (right[i] * inverse[i]);
}

HADA_CLONES_AVX512 void residual(int n, float* __restrict out, const float* x, const Around& value,
                                 const float* right, const std::uint8_t* code) {
  const float *const up = value.up, *const down = value.down;
  const float *const left = value.left, *const beyond = value.right;
  for (int i = 0; i < n; ++i) {
    const float sum = (up[i] + down[i]) + (left[i] + beyond[i]);
    const float edges = float(code[i] & 15);
    const float rest = (right[i] + sum) - edges * x[i];
    out[i] = edges > 0.0f ? rest : 0.0f;
  }
}

HADA_CLONES_AVX512 void residual(int n, float* __restrict out, const float* x, const Around& value,
                                 const Around& weight, const float* right, const float* inverse,
                                 const std::uint8_t* even) {
  const float *const up = value.up, *const down = value.down;
  const float *const left = value.left, *const beyond = value.right;
  const float *const wu = weight.up, *const wd = weight.down;
  const float *const wl = weight.left, *const wr = weight.right;
  for_marked(
      n, even, 1,
      [=](int i) {
        const float here = x[i];
        out[i] = right[i] +
                 (((up[i] - here) + (down[i] - here)) + ((left[i] - here) + (beyond[i] - here)));
      },
      [=](int i) {
        const float here = x[i];
        const float rest = right[i] + ((wu[i] * (up[i] - here) + wd[i] * (down[i] - here)) +
                                       (wl[i] * (left[i] - here) + wr[i] * (beyond[i] - here)));
        out[i] = inverse[i] > 0.0f ? rest : 0.0f;
      });
}

HADA_CLONES_AVX512 void exact_residual(int n, float* out, const float* x, const Around& value,
                                       const float* right, const std::uint8_t* code,
                                       const AroundCodes& around) {
  const float *const up = value.up, *const down = value.down;
  const float *const left = value.left, *const beyond = value.right;
  const std::uint8_t *const cu = around.up, *const cd = around.down;
  const std::uint8_t *const cl = around.left, *const cr = around.right;
  for_marked(
      n, code, edge_code(4),
      [=](int i) {
        const float here = x[i];
        out[i] = right[i] +
                 (((up[i] - here) + (down[i] - here)) + ((left[i] - here) + (beyond[i] - here)));
      },
      [=](int i) {
        const float here = x[i];
        const float du = up[i] - here, dd = down[i] - here;
        const float dl = left[i] - here, dr = beyond[i] - here;
        const float vertical = (cu[i] ? du : 0.0f) + (cd[i] ? dd : 0.0f);
        const float level = (cl[i] ? dl : 0.0f) + (cr[i] ? dr : 0.0f);
        const float sum = right[i] + (vertical + level);
        out[i] = code[i] ? sum : 0.0f;
      });
}

HADA_CLONES_AVX512 void edge_codes(int n, const std::uint8_t* above, const std::uint8_t* here,
                                   const std::uint8_t* below, std::uint8_t* __restrict codes) {
  // Without a branch, so that many pixels are looked at together.
  const auto chosen = [](bool yes, std::uint8_t value) { return std::uint8_t(-int(yes) & value); };
  for (int i = 0; i < n; ++i) {
    const std::uint8_t count =
        std::uint8_t((above[i] != 0) + (below[i] != 0) + (here[i - 1] != 0) + (here[i + 1] != 0));
    const std::uint8_t code =
        std::uint8_t((chosen(count == 1, edge_code(1)) | chosen(count == 2, edge_code(2))) |
                     (chosen(count == 3, edge_code(3)) | chosen(count == 4, edge_code(4))));
    codes[i] = chosen(here[i] != 0, code);
  }
}

HADA_CLONES_AVX2 void add_carried(int n, float factor, float* __restrict x, const Corner& even,
                                  const Corner& odd, const std::uint8_t* alive) {
  add_eights(
      n, factor, x, even,
      odd, [=](int i) __attribute__((always_inline)) { return load_flags(alive + i); });
}

HADA_CLONES_AVX2 void add_carried(int n, float factor, float* __restrict x, const Corner& even,
                                  const Corner& odd, const float* alive) {
  add_eights(
      n, factor, x, even,
      odd, [=](int i) __attribute__((always_inline)) { return load(alive + i) > 0.0f; });
}

}  // namespace hada::row_kernels
