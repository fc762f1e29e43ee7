#include "reconstruct/coarsen_kernels.h"

#include "reconstruct/clones.h"

namespace hada::coarsen_kernels {

HADA_CLONES_AVX512 void join(int n, const UnitRows& codes, float* __restrict inside_across,
                             float* __restrict inside_along, float* __restrict cross_across,
                             float* __restrict cross_along, float* __restrict split) {
  const auto [a0, b0, a1, b1, a2, b2] = codes;
  for (int j = 0; j < n; ++j) {
    const int p = a0[j] != 0, q = b0[j] != 0, r = a1[j] != 0, s = b1[j] != 0;
    const int across = (p & q) + (r & s);
    const int along = (p & r) + (q & s);
    inside_across[j] = float(across);
    inside_along[j] = float(along);
    cross_across[j] = float((q & (a0[j + 1] != 0)) + (s & (a1[j + 1] != 0)));
    cross_along[j] = float((r & (a2[j] != 0)) + (s & (b2[j] != 0)));
    const int parts = p + q + r + s - across - along + (p & q & r & s);
    split[j] = parts > 1 ? 1.0f : 0.0f;
  }
}

HADA_CLONES_AVX512 void join(int n, const WeightedRows& rows, float least,
                             float* __restrict inside_across, float* __restrict inside_along,
                             float* __restrict cross_across, float* __restrict cross_along,
                             float* __restrict split) {
  const auto [ab0, ba0, ab1, ba1, a01, b01, a12, b12, a0, b0, a1, b1] = rows;
  const auto smaller = [](float a, float b) { return a < b ? a : b; };
  for (int j = 0; j < n; ++j) {
    inside_across[j] = ab0[j] + ab1[j];
    inside_along[j] = a01[j] + b01[j];
    cross_across[j] = ba0[j] + ba1[j];
    cross_along[j] = a12[j] + b12[j];
    const int top = ab0[j] * smaller(a0[j], b0[j]) >= least;
    const int bottom = ab1[j] * smaller(a1[j], b1[j]) >= least;
    const int left = a01[j] * smaller(a0[j], a1[j]) >= least;
    const int right = b01[j] * smaller(b0[j], b1[j]) >= least;
    const int alive = (a0[j] > 0.0f) + (b0[j] > 0.0f) + (a1[j] > 0.0f) + (b1[j] > 0.0f);
    const int parts = alive - (top + bottom + left + right) + (top & bottom & left & right);
    split[j] = parts > 1 ? 1.0f : 0.0f;
  }
}

HADA_CLONES_AVX512 void in_series(int n, float* __restrict cross, const float* reach,
                                  const float* reach_beyond) {
  for (int i = 0; i < n; ++i) {
    cross[i] = cross[i] / (1.0f + cross[i] * (reach[i] + reach_beyond[i]));
  }
}

HADA_CLONES_AVX512 void to_reach(int n, float* __restrict reach) {
  for (int i = 0; i < n; ++i) reach[i] = reach[i] > 0.0f ? 0.5f / reach[i] : 0.0f;
}

HADA_CLONES_AVX512 void find_even(int n, const row_kernels::Around& weight,
                                  const float* reach_across, const float* reach_along,
                                  const float* inverse, std::uint8_t* __restrict even) {
  const float *const wu = weight.up, *const wd = weight.down;
  const float *const wl = weight.left, *const wr = weight.right;
  for (int i = 0; i < n; ++i) {
    const int edges = (wu[i] == 1.0f) & (wd[i] == 1.0f) & (wl[i] == 1.0f) & (wr[i] == 1.0f);
    const int cell = (reach_across[i] == 0.25f) & (reach_along[i] == 0.25f) & (inverse[i] == 0.25f);
    even[i] = std::uint8_t(edges & cell);
  }
}

HADA_CLONES_AVX512 void invert(int n, float* __restrict inverse,
                               const row_kernels::Around& weight) {
  const float *const wu = weight.up, *const wd = weight.down;
  const float *const wl = weight.left, *const wr = weight.right;
  for (int i = 0; i < n; ++i) {
    const float sum = (wu[i] + wd[i]) + (wl[i] + wr[i]);
    inverse[i] = sum > 0.0f ? 1.0f / sum : 0.0f;
  }
}

}  // namespace hada::coarsen_kernels
