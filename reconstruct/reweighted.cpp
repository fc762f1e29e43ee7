#include "reconstruct/reweighted.h"

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr int few_samples = 6;
constexpr float settled =
    1e-4f;  // radians, or of the albedo: a tenth of what the best noise leaves

struct Huber {
  static constexpr bool from_middle = false;
  static constexpr int rounds = 20;
  [[gnu::always_inline]] static Lanes weight(const Lanes& r, const Lanes& s) {
    const Lanes edge = all(1.345f) * s;
    return edge / larger(edge, magnitude(r));
  }
};

struct Cauchy {
  static constexpr bool from_middle = false;
  static constexpr int rounds = 20;
  [[gnu::always_inline]] static Lanes weight(const Lanes& r, const Lanes& s) {
    const Lanes t = r / (all(2.385f) * s);
    return all(1.0f) / (all(1.0f) + t * t);
  }
};

struct LeastAbsolute {
  static constexpr bool from_middle = false;
  static constexpr int rounds = 30;
  [[gnu::always_inline]] static Lanes weight(const Lanes& r, const Lanes& s) {
    const Lanes near_zero = all(0.1f) * s;  // where |r| is rounded off, or weights would not end
    return near_zero / larger(near_zero, magnitude(r));
  }
};

struct Biweight {
  static constexpr bool from_middle = true;
  static constexpr int rounds = 8;
  [[gnu::always_inline]] static Lanes weight(const Lanes& r, const Lanes& s) {
    const Lanes t = r / (all(4.685f) * s);
    const Lanes w = larger(all(0.0f), all(1.0f) - t * t);
    return w * w;
  }
};

struct BiweightAgain : Biweight {
  static constexpr int rounds = 4;
};

// Least squares between two ranks of brightness, as shares of the samples.
template <bool near>
[[gnu::always_inline]] inline Lanes3 middle_fit(const Block<near>& block, const LaneBits& count,
                                                float* scratch) {
  sorted_greys(block, scratch);
  const LaneBits low = count / 5;
  const LaneBits high = count > 0 ? count - 1 - low : count;
  return fit_between(block, at_rank(scratch, low), at_rank(scratch, high));
}

// 1.4826 median |r| sqrt(n / (n - 3)) of the samples that may count.
template <bool near>
[[gnu::always_inline]] inline Lanes scale_of(const Block<near>& block, const Lanes3& found,
                                             const LaneBits& count, float* scratch) {
  for (int k = 0; k < block.tile.lights; ++k) {
    store(scratch + k * lane_count, chosen(block.trust(k) > all(0.0f),
                                           magnitude(residual(block, k, found)), all(beyond_all)));
  }
  sort(block.tile, scratch);
  const LaneBits one = LaneBits{} + 1;
  const LaneBits n = count > 3 ? count : 3 * one + one;
  const LaneBits upper = n / 2 < block.tile.lights ? n / 2 : LaneBits{} + (block.tile.lights - 1);
  const Lanes median = all(0.5f) * (at_rank(scratch, (n - 1) / 2 < upper ? (n - 1) / 2 : upper) +
                                    at_rank(scratch, upper));
  const Lanes share = __builtin_convertvector(n, Lanes) / __builtin_convertvector(n - 3, Lanes);
  return all(1.4826f) * median * root(share);
}

template <class Rule, bool near>
[[gnu::always_inline]] inline void reweigh(Tile& tile, bool from_found) {
  float* scratch = tile.scratch.data();
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    const LaneBits count = trusted(block);
    const LaneBits few = count < few_samples;
    const auto pixel = std::size_t(first);
    Lanes3 found{load(&tile.x[pixel]), load(&tile.y[pixel]), load(&tile.z[pixel])};
    if (!from_found) {
      found = fit_between(block, all(-beyond_all), all(beyond_all));
      if constexpr (Rule::from_middle) {
        const Lanes3 middle = middle_fit(block, count, scratch);
        const LaneBits use = ~few & (dot(middle, middle) > all(0.0f));
        found = {chosen(use, middle.x, found.x), chosen(use, middle.y, found.y),
                 chosen(use, middle.z, found.z)};
      }
    }
    LaneBits moving = LaneBits{} - 1;
    for (int round = 0; round < Rule::rounds && any(moving); ++round) {
      const Lanes scale = larger(scale_of(block, found, count, scratch), least_sigma(tile, found));
      NormalEquations sums;
      for (int k = 0; k < tile.lights; ++k) {
        const Lanes3 l = block.to_light(k);
        const Lanes predicted = dot(l, found);
        const Lanes r = block.grey(k) - predicted;
        Lanes w = Rule::weight(r, scale);
        if constexpr (Rule::from_middle) w = chosen(predicted > all(0.0f), w, all(0.0f));
        w = block.trust(k) * chosen(few, all(1.0f), w);
        sums.add(w, l, r);
        const Lanes before = load(&tile.weight[tile.at(k, first)]);
        store(&tile.weight[tile.at(k, first)], chosen(moving, w, before));
      }
      const Lanes3 step = Inverse(sums) * sums.right;
      found.x += chosen(moving, step.x, all(0.0f));
      found.y += chosen(moving, step.y, all(0.0f));
      found.z += chosen(moving, step.z, all(0.0f));
      moving = moving & (dot(step, step) > all(settled * settled) * dot(found, found));
    }
    store(tile, first, found);
  }
}

template <class Rule>
[[gnu::always_inline]] inline void reweigh(Tile& tile, bool from_found = false) {
  if (tile.near) {
    reweigh<Rule, true>(tile, from_found);
  } else {
    reweigh<Rule, false>(tile, from_found);
  }
}

}  // namespace

HADA_CLONES_AVX2 void fit_huber(Tile& tile) {
  reweigh<Huber>(tile);
}

HADA_CLONES_AVX2 void fit_cauchy(Tile& tile) {
  reweigh<Cauchy>(tile);
}

HADA_CLONES_AVX2 void fit_l1(Tile& tile) {
  reweigh<LeastAbsolute>(tile);
}

HADA_CLONES_AVX2 void fit_biweight(Tile& tile) {
  reweigh<Biweight>(tile);
}

HADA_CLONES_AVX2 void refit_biweight(Tile& tile) {
  reweigh<BiweightAgain>(tile, true);
}

}  // namespace hada
