#include "reconstruct/unit_normals.h"

#include <cstddef>

#include "reconstruct/tile_fit.h"

namespace hada {
namespace {

constexpr float least_z = 0.02f;

[[gnu::always_inline]] inline void split(Tile& tile) {
  for (int first = 0; first < tile.pixels; first += lane_count) {
    const auto i = std::size_t(first);
    const Lanes3 found{load(&tile.x[i]), load(&tile.y[i]), load(&tile.z[i])};
    const Lanes rho = root(dot(found, found));
    const LaneBits good = (found.z > all(least_z) * rho) & (rho < all(beyond_all));
    const Lanes scale = all(1.0f) / chosen(good, rho, all(1.0f));
    store(&tile.x[i], found.x * scale);
    store(&tile.y[i], found.y * scale);
    store(&tile.z[i], found.z * scale);
    store(&tile.rho[i], chosen(good, rho, all(0.0f)));
  }
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] void split_albedo(Tile& tile) {
  split(tile);
}

}  // namespace hada
