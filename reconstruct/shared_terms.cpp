#include "reconstruct/shared_terms.h"

#include "reconstruct/clones.h"
#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

// Over the albedo.
struct Shading {
  Lanes cosine;
  Lanes departure;  // from it
};

template <bool near>
[[gnu::always_inline]] inline Shading shade(const Block<near>& block, int k, const Lanes3& normal,
                                            const SharedTerms& terms) {
  const Lanes t = larger(all(0.0f), dot(block.to_light(k), normal));
  const Lanes u = all(1.0f) - t;
  const float* c = terms.curve;
  Lanes departure = t * u * (all(c[0]) + u * (all(c[1]) + u * all(c[2])));
  if (!terms.off.empty()) {
    const float* off = &terms.off[3 * std::size_t(k)];
    const Lanes3 error{all(off[0]), all(off[1]), all(off[2])};
    Lanes added = dot(error, normal);
    if constexpr (near) {
      const Lanes3 l = block.to_light(k);
      added -= all(3.0f) * dot(l, error) * dot(l, normal);
      added *= load(&block.tile.closeness[block.tile.at(k, block.first)]);
    }
    departure += added;
  }
  return {t, departure};
}

[[gnu::always_inline]] inline Lanes3 unit(const Tile& tile, int first, Lanes& rho) {
  const auto pixel = std::size_t(first);
  const Lanes3 found{load(&tile.x[pixel]), load(&tile.y[pixel]), load(&tile.z[pixel])};
  rho = root(dot(found, found));
  const Lanes scale = all(1.0f) / larger(rho, all(1e-20f));
  return {found.x * scale, found.y * scale, found.z * scale};
}

template <bool near>
[[gnu::always_inline]] inline void take(Tile& tile, const SharedTerms& terms) {
  const bool bounced = !tile.bounce.empty() && terms.bounce != 0.0f;
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    Lanes rho;
    const Lanes3 normal = unit(tile, first, rho);
    for (int k = 0; k < tile.lights; ++k) {
      const std::size_t i = tile.at(k, first);
      Lanes value = load(&tile.raw[i]) - rho * shade(block, k, normal, terms).departure;
      if (bounced) value -= all(terms.bounce) * load(&tile.bounce[i]);
      store(&tile.grey[i], value);
    }
  }
}

template <bool near>
[[gnu::always_inline]] inline void show(const Tile& tile, const SharedTerms& terms,
                                        float* shading) {
  const bool bounced = !tile.bounce.empty() && terms.bounce != 0.0f;
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const Block<near> block{tile, first};
    Lanes rho;
    const Lanes3 normal = unit(tile, first, rho);
    for (int k = 0; k < tile.lights; ++k) {
      const std::size_t i = tile.at(k, first);
      const Shading shown = shade(block, k, normal, terms);
      Lanes value = shown.cosine + shown.departure;
      if (bounced) value += all(terms.bounce) * load(&tile.bounce[i]) / larger(rho, all(1e-20f));
      store(shading + i, value);
    }
  }
}

}  // namespace

HADA_CLONES_AVX2 void take_off(Tile& tile, const SharedTerms& terms) {
  if (tile.near) {
    take<true>(tile, terms);
  } else {
    take<false>(tile, terms);
  }
}

HADA_CLONES_AVX2 void shading_of(const Tile& tile, const SharedTerms& terms,
                                 std::vector<float>& shading) {
  shading.resize(tile.grey.size());
  if (tile.near) {
    show<true>(tile, terms, shading.data());
  } else {
    show<false>(tile, terms, shading.data());
  }
}

}  // namespace hada
