#pragma once

#include <vector>

#include "reconstruct/tile.h"

namespace hada {

/// What all pixels have in common, beyond Lambert under the lights that are given:
///
///     I = rho (n.l) (1 + c(n.l)) + bounce * b + rho n.d
///
/// c(t) = sum_j curve[j] (1 - t)^(j + 1) says how a material departs from the cosine (roughness,
/// retro-reflection, the diffuse lobe under a coat); c(1) = 0, the albedo takes the rest. b is the
/// light that other parts of the surface throw on a sample, in `Tile::bounce`. d is what a light is
/// off, in direction and strength, as far as the pixels agree on it: what they cannot agree on
/// stays.
struct SharedTerms {
  float curve[3] = {0.0f, 0.0f, 0.0f};
  float bounce = 0.0f;
  std::vector<float> off;  // d or e of each light, three values; empty: none

  bool curved() const { return curve[0] != 0.0f || curve[1] != 0.0f || curve[2] != 0.0f; }
};

/// tile.grey: tile.raw without the shared terms, for the normals that the tile holds now.
void take_off(Tile& tile, const SharedTerms& terms);

/// shading[k * stride + i]: what an albedo of 1 would show, all terms in it.
void shading_of(const Tile& tile, const SharedTerms& terms, std::vector<float>& shading);

}  // namespace hada
