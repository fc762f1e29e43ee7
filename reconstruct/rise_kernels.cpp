#include "reconstruct/rise_kernels.h"

#include "reconstruct/clones.h"

namespace hada::rise_kernels {

HADA_CLONES_AVX512 void rise_across(int n, const float* slopes, const std::uint8_t* mask,
                                    float magic, float* __restrict rise) {
  for (int i = 0; i < n; ++i) {
    const float mean = (0.5f * (slopes[2 * i] + slopes[2 * i + 2]) + magic) - magic;
    const bool both = (mask[i] != 0) & (mask[i + 1] != 0);
    rise[i] = both ? mean : 0.0f;
  }
}

HADA_CLONES_AVX512 void rise_down(int n, const float* slopes, const float* slopes_below,
                                  const std::uint8_t* mask, const std::uint8_t* mask_below,
                                  float magic, float* __restrict rise) {
  for (int i = 0; i < n; ++i) {
    const float mean = (-0.5f * (slopes[2 * i + 1] + slopes_below[2 * i + 1]) + magic) - magic;
    const bool both = (mask[i] != 0) & (mask_below[i] != 0);
    rise[i] = both ? mean : 0.0f;
  }
}

HADA_CLONES_AVX512 void balance(int n, const float* across, const float* above, const float* below,
                                float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = (across[i - 1] - across[i]) + (above[i] - below[i]);
}

}  // namespace hada::rise_kernels
