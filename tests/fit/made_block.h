#pragma once

#include <cmath>
#include <vector>

#include "core/random.h"
#include "fit/block.h"

/// A stem that leans and tapers, and pictures of two sides of a block of it.
namespace hada {

inline const Cut end_cut, face_cut = cut_along({16.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});

inline Wood<> made_stem() {
  Wood<> wood;
  wood.pith_mm = {-3.0, 2.0};
  wood.pith_lean = {0.012, -0.02};
  wood.taper = 0.018;
  wood.lobes = {{2.0, 0.02, -0.03}, {3.0, 0.006, 0.004}};
  wood.spiral = 0.08;
  wood.fibre_shift = 0.2;
  wood.fibre_mm = 0.15;
  wood.ring_radii_mm.clear();
  double radius = 0.0;
  for (int k = 0; k < 24; ++k) wood.ring_radii_mm.push_back(radius += 1.6 + 1.2 * uniform(3, k));
  return wood;
}

/// A cut drawn twice as fine as it is looked at, with noise and 8 bits.
inline PlacedFace face_of(Wood<> wood, const char* name, const Cut& cut, int rows, int cols) {
  wood.cut_origin_mm.assign(cut.origin.begin(), cut.origin.end());
  wood.cut_right.assign(cut.right.begin(), cut.right.end());
  wood.cut_up.assign(cut.up.begin(), cut.up.end());
  const Surface fine = surface_of(wood, {2 * rows, 2 * cols, 0.05, Unit::mm}, 5);
  PlacedFace face{name, {}, cut};
  face.surface.extent = {rows, cols, 0.1, Unit::mm};
  face.surface.mask = full_mask(face.surface.extent);
  face.surface.albedo = Image(rows, cols, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& from = fine.albedo.planes[c];
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) sum += double(from(2 * row + k / 2, 2 * col + k % 2));
        const double noisy = 0.25 * sum + 0.01 * gaussian(77, row, col, int(c));
        face.surface.albedo.planes[c](row, col) = float(std::round(255.0 * noisy) / 255.0);
      }
    }
  }
  return face;
}

/// Its end grain and a tangential face.
inline std::vector<PlacedFace> made_faces() {
  return {face_of(made_stem(), "end", end_cut, 420, 420),
          face_of(made_stem(), "face", face_cut, 500, 420)};
}

}  // namespace hada
