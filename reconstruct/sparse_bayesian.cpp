#include "reconstruct/sparse_bayesian.h"

#include <cstddef>

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr int rounds = 100;
constexpr float relative_lambda = 1e-6f;  // of the squared albedo

template <bool near>
[[gnu::always_inline]] inline void learn(Tile& tile) {
  float* gamma = tile.scratch.data();
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    Lanes3 found = fit_between(block, all(-beyond_all), all(beyond_all));
    const Lanes albedo_squared = dot(found, found) + all(1e-20f);
    const Lanes lambda = all(relative_lambda) * albedo_squared;
    for (int k = 0; k < tile.lights; ++k) store(gamma + k * lane_count, albedo_squared);
    for (int round = 0; round < rounds; ++round) {
      NormalEquations sums;
      for (int k = 0; k < tile.lights; ++k) {
        // Weights are relative to 1 / lambda, so that they stay within the range of a float.
        const Lanes w = block.trust(k) * lambda / (load(gamma + k * lane_count) + lambda);
        sums.add(w, block.to_light(k), residual(block, k, found));
        store(&tile.weight[tile.at(k, first)], w);
      }
      const Inverse inverse(sums);
      const Lanes3 step = inverse * sums.right;
      found.x += step.x;
      found.y += step.y;
      found.z += step.z;
      for (int k = 0; k < tile.lights; ++k) {
        const Lanes g = load(gamma + k * lane_count);
        const Lanes share = g / (g + lambda);
        const Lanes3 l = block.to_light(k);
        const Lanes error = share * residual(block, k, found);
        // The posterior variance of e_k: gamma lambda / (gamma + lambda), and what x adds.
        const Lanes variance = share * lambda + share * share * lambda * dot(l, inverse * l);
        store(gamma + k * lane_count, error * error + variance);
      }
    }
    store(tile, first, found);
  }
}

}  // namespace

HADA_CLONES_AVX2 void fit_sparse_bayesian(Tile& tile) {
  if (tile.near) {
    learn<true>(tile);
  } else {
    learn<false>(tile);
  }
}

}  // namespace hada
