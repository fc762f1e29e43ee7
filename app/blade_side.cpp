#include "app/blade_side.h"

#include <algorithm>

namespace hada {
namespace {

constexpr float iron[3] = {0.56f, 0.57f, 0.58f};  // reflectance of iron at normal incidence
constexpr float dark_grain = 0.75f;               // share that the darkest grain takes from it
constexpr float hardened_bright = 1.4f;           // as polishing whitens it

/// The etched grain of the picture of one side, in waves if asked for: 0 to 1.
Grid<float> grain_of(const Forged<>& forged, const AyasugiShape& shape, int rows, int cols,
                     Seed seed) {
  auto block = forged_block(forged, divisible({rows, cols}, forged.sequence), seed);
  block = ayasugi(block, shape);
  quantise(block, 1.0, forged.step / forged.levels);
  return crop(block, 0, 0, rows, cols);
}

Image colours(const Grid<float>& grain, const Grid<float>& hard) {
  Image picture(grain.rows(), grain.cols(), 3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < grain.size(); ++k) {
      const float bright = 1.0f - dark_grain * (1.0f - grain[k]);
      const float whiter = 1.0f + (hardened_bright - 1.0f) * hard[k];
      picture.planes[c][k] = std::min(1.0f, iron[c] * bright * whiter);
    }
  }
  return picture;
}

}  // namespace

BladeSide blade_side(const Forged<>& forged, double length_mm, int cols, const BladeLook& look,
                     Seed seed) {
  const int rows = std::max(cols / 8, 1);
  BladeSide side;
  side.grain = grain_of(forged, look.ayasugi, rows, cols, seed);
  side.hard = hamon_mask(rows, cols, look.hamon, seed);
  Surface& surface = side.surface;
  surface.extent = {rows, cols, length_mm / cols, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = colours(side.grain, side.hard);
  surface.height = side.grain;
  for (float& height : surface.height) height *= float(forged.etch_mm);
  surface.normals = normals_of(surface.height, surface.mask, surface.extent.pitch);
  return side;
}

}  // namespace hada
