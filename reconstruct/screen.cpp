#include "reconstruct/screen.h"

#include <cstddef>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr float doubt = 3.0f;  // sigma; one of 370 normal errors lies beyond
constexpr float least_left =
    0.05f;  // of 1 - leverage: without such a sample the others do not span space

[[gnu::always_inline]] inline Lanes most_squared(const Tile& tile, const Lanes3& found) {
  return all(doubt * doubt) * least_variance(tile, found);
}

template <bool near>
[[gnu::always_inline]] inline void look(const Tile& tile, std::uint8_t* doubtful) {
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    const Lanes3 found = block.found();
    Lanes most{};
    Lanes least = all(1.0f);
    for (int k = 0; k < tile.lights; ++k) {
      const Lanes predicted = dot(block.to_light(k), found);
      const Lanes r = block.grey(k) - predicted;
      most = larger(most, r * r);
      least = smaller(least, predicted);
      if (!tile.trusts_all) least = smaller(least, block.trust(k));
    }
    store_flags(doubtful + first, (most > most_squared(tile, found)) | (least <= all(0.0f)));
  }
}

[[gnu::always_inline]] inline void drop(Tile& tile, const float* pseudo_inverse,
                                        std::uint8_t* doubtful) {
  const float* to_x = pseudo_inverse;
  const float* to_y = to_x + tile.lights;
  const float* to_z = to_y + tile.lights;
  float* gain = tile.scratch.data();  // 1 / (1 - h), or 0 for a light that cannot be missed
  for (int k = 0; k < tile.lights; ++k) {
    const auto i = std::size_t(k);
    const float left =
        1.0f - (tile.x_to[i] * to_x[k] + tile.y_to[i] * to_y[k] + tile.z_to[i] * to_z[k]);
    gain[k] = left > least_left ? 1.0f / left : 0.0f;
  }
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<false> block{tile, first};
    Lanes3 found = block.found();
    Lanes most{};
    Lanes3 step{};
    LaneBits worst = LaneBits{} - 1;
    for (int k = 0; k < tile.lights; ++k) {
      const Lanes r = residual(block, k, found);
      const Lanes change = r * all(gain[k]);
      const Lanes fall = r * change;
      const LaneBits worse = fall > most;
      most = larger(fall, most);
      worst = worse ? LaneBits{} + k : worst;
      step = {chosen(worse, all(to_x[k]) * change, step.x),
              chosen(worse, all(to_y[k]) * change, step.y),
              chosen(worse, all(to_z[k]) * change, step.z)};
    }
    found = {found.x - step.x, found.y - step.y, found.z - step.z};
    store(tile, first, found);
    const Lanes limit = most_squared(tile, found);
    LaneBits bad{};
    for (int k = 0; k < tile.lights; ++k) {
      const LaneBits kept = worst != k;
      const Lanes predicted = dot(block.to_light(k), found);
      const Lanes r = block.grey(k) - predicted;
      bad |= kept & ((r * r > limit) | (predicted <= all(0.0f)));
      store(&tile.weight[tile.at(k, first)], chosen(kept, all(1.0f), all(0.0f)));
    }
    store_flags(doubtful + first, bad);
  }
}

}  // namespace

HADA_CLONES_AVX2 void screen(const Tile& tile, std::vector<std::uint8_t>& doubtful) {
  doubtful.resize(std::size_t(tile.stride));
  if (tile.near) {
    look<true>(tile, doubtful.data());
  } else {
    look<false>(tile, doubtful.data());
  }
}

HADA_CLONES_AVX2 void drop_worst(Tile& tile, const std::vector<float>& pseudo_inverse,
                                 std::vector<std::uint8_t>& doubtful) {
  doubtful.resize(std::size_t(tile.stride));
  drop(tile, pseudo_inverse.data(), doubtful.data());
}

}  // namespace hada
