#include "reconstruct/judge.h"

#include <algorithm>
#include <cstddef>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr float least_left = 0.05f;  // of 1 - leverage: a sample that its pixel hangs on

[[gnu::always_inline]] inline void add_to(float* sums, int which, const Lanes& values) {
  store(sums + which * lane_count, load(sums + which * lane_count) + values);
}

// Sum over the modes of the squared part across the normal of what a mode moves rho n by.
[[gnu::always_inline]] inline Lanes together(const LightDoubt& doubt, int lights,
                                             const Lanes3& found, const Lanes3& normal,
                                             const float* gains) {
  Lanes total{};
  const std::size_t length = 3 * std::size_t(lights);
  for (std::size_t first = 0; first < doubt.modes.size(); first += length) {
    Lanes3 moved{all(0.0f), all(0.0f), all(0.0f)};
    for (int k = 0; k < lights; ++k) {
      const float* mode = &doubt.modes[first + 3 * std::size_t(k)];
      const float* gain = gains + 3 * k * lane_count;
      const Lanes change = found.x * all(mode[0]) + found.y * all(mode[1]) + found.z * all(mode[2]);
      moved.x += change * load(gain);
      moved.y += change * load(gain + lane_count);
      moved.z += change * load(gain + 2 * lane_count);
    }
    const Lanes along = dot(normal, moved);
    total += dot(moved, moved) - along * along;
  }
  return total;
}

template <bool near>
[[gnu::always_inline]] inline void weigh(const Tile& tile, const LightDoubt& doubt,
                                         const float* inside, Judgement& judgement) {
  const float* tilt_squared = doubt.tilt_squared.data();
  float* sums_by_light = judgement.scratch.data();
  for (float& sum : judgement.scratch) sum = 0.0f;
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    const auto pixel = std::size_t(first);
    const Lanes3 found{load(&tile.x[pixel]), load(&tile.y[pixel]), load(&tile.z[pixel])};
    const Lanes counts = load(inside + first);
    const Lanes rho_squared = larger(dot(found, found), all(1e-20f));
    const Lanes scale = all(1.0f) / root(rho_squared);
    const Lanes3 normal{found.x * scale, found.y * scale, found.z * scale};
    NormalEquations equations;
    for (int k = 0; k < tile.lights; ++k) {
      equations.add(load(&tile.weight[tile.at(k, first)]), block.to_light(k), all(0.0f));
    }
    const Inverse inverse(equations);
    Lanes squares{}, counted{}, inliers{}, light_variance{};
    for (int k = 0; k < tile.lights; ++k) {
      const std::size_t i = tile.at(k, first);
      const Lanes3 l = block.to_light(k);
      const Lanes w = load(&tile.weight[i]);
      const Lanes r = residual(block, k, found);
      const Lanes3 g = inverse * l;
      const Lanes leverage = w * dot(g, l);
      const Lanes cosine = dot(normal, l);
      const Lanes variance =
          rho_squared * all(tilt_squared[k]) * larger(all(0.0f), all(1.0f) - cosine * cosine);
      squares += w * (r * r - variance * (all(1.0f) - leverage));
      counted += w;
      inliers += chosen(w >= all(0.5f), all(1.0f), all(0.0f));
      const Lanes along = dot(normal, g);
      light_variance += variance * w * w * (dot(g, g) - along * along);
      float* gain = &judgement.gains[std::size_t(3 * k * lane_count)];
      store(gain, w * g.x);
      store(gain + lane_count, w * g.y);
      store(gain + 2 * lane_count, w * g.z);
      const Lanes value = load(tile.raw.empty() ? &tile.grey[i] : &tile.raw[i]);
      const Lanes believed = counts * block.trust(k);
      const Lanes missed = r / larger(all(least_left), all(1.0f) - leverage);
      const LaneBits take = counts > all(0.0f);  // others may hold anything
      const Lanes none = all(0.0f);
      float* sums = sums_by_light + 4 * k * lane_count;
      add_to(sums, 0, chosen(take, believed * value * value, none));
      add_to(sums, 1, chosen(take, w * r * r, none));
      add_to(sums, 2, chosen(take, w * value * value, none));
      add_to(sums, 3, chosen(take, believed * missed * missed, none));
    }
    if (!doubt.modes.empty()) {
      light_variance = together(doubt, tile.lights, found, normal, judgement.gains.data());
    }
    const Lanes along = dot(normal, inverse * normal);
    const Lanes across = inverse.xx + inverse.yy + inverse.zz - along;
    store(&judgement.squares[pixel], squares);
    store(&judgement.freedom[pixel], counted - all(3.0f));
    store(&judgement.noise_gain[pixel], across / (all(2.0f) * rho_squared));
    store(&judgement.light_variance[pixel], light_variance / (all(2.0f) * rho_squared));
    store(&judgement.albedo_gain[pixel], along / rho_squared);
    store(&judgement.inliers[pixel], inliers);
  }
  for (int k = 0; k < tile.lights; ++k) {
    const float* sums = sums_by_light + 4 * k * lane_count;
    const auto light = std::size_t(k);
    for (int i = 0; i < lane_count; ++i) {
      judgement.picture[light] += double(sums[i]);
      judgement.used[light] += double(sums[lane_count + i]);
      judgement.used_picture[light] += double(sums[2 * lane_count + i]);
      judgement.left_out[light] += double(sums[3 * lane_count + i]);
    }
  }
}

}  // namespace

Judgement::Judgement(int lights, int most_pixels)
    : scratch(4 * std::size_t(lights) * lane_count, 0.0f),
      gains(3 * std::size_t(lights) * lane_count, 0.0f) {
  const std::size_t padded = std::size_t((most_pixels + lane_count - 1) / lane_count * lane_count);
  for (auto* values : {&squares, &freedom, &noise_gain, &light_variance, &albedo_gain, &inliers}) {
    values->assign(padded, 0.0f);
  }
  for (auto* sums : {&picture, &used, &used_picture, &left_out}) {
    sums->assign(std::size_t(lights), 0.0);
  }
}

HADA_CLONES_AVX2 void judge(const Tile& tile, const LightDoubt& doubt,
                            const std::vector<float>& inside, Judgement& judgement) {
  if (tile.near) {
    weigh<true>(tile, doubt, inside.data(), judgement);
  } else {
    weigh<false>(tile, doubt, inside.data(), judgement);
  }
}

}  // namespace hada
