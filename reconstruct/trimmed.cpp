#include "reconstruct/trimmed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr int least_samples = 4;

template <bool near>
[[gnu::always_inline]] inline void trim(Tile& tile, const RankWindow& window) {
  float* sorted = tile.scratch.data();
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    const LaneBits count = trusted(block);
    sorted_greys(block, sorted);
    LaneBits low;
    LaneBits high;
    for (int i = 0; i < lane_count; ++i) {
      const int n = count[i];
      int begin = int(std::ceil(window.low * float(n)));
      int end = int(std::ceil(window.high * float(n)));
      while (end - begin < std::min(n, least_samples)) {
        if (begin > 0) --begin;
        if (end < n) ++end;
      }
      low[i] = std::min(begin, tile.lights - 1);
      high[i] = std::clamp(end - 1, 0, tile.lights - 1);
    }
    const Lanes darkest = at_rank(sorted, low);
    const Lanes brightest = at_rank(sorted, high);
    store(tile, first, fit_between(block, darkest, brightest));
    for (int k = 0; k < tile.lights; ++k) {
      const Lanes grey = block.grey(k);
      const LaneBits inside = (grey >= darkest) & (grey <= brightest);
      store(&tile.weight[tile.at(k, first)], chosen(inside, block.trust(k), all(0.0f)));
    }
  }
}

}  // namespace

HADA_CLONES_AVX2 void fit_trimmed(Tile& tile, const RankWindow& window) {
  if (tile.near) {
    trim<true>(tile, window);
  } else {
    trim<false>(tile, window);
  }
}

}  // namespace hada
