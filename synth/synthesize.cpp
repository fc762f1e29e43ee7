#include "synth/synthesize.h"

#include <cmath>
#include <variant>

#include "core/error.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr float plain_albedo = 0.8f;

// A fact of the spectrum alone: luck draws the phases, and the sheet is of one colour.
template <Spectral M>
Surface drawn(const M& material, const Extent& extent, Seed seed) {
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.height = gaussian_field(spectrum_of(material), extent, seed);
  surface.normals = normals_of(surface.height, surface.mask, extent.pitch);
  surface.albedo = Image(Grid<float>(extent.rows, extent.cols, plain_albedo));
  return surface;
}

}  // namespace

Surface synthesize(const Material& material, const Extent& extent, Seed seed) {
  if (extent.rows < 1 || extent.cols < 1) {
    throw Error("synthesis: the surface has no pixels; ask for at least 1 x 1");
  }
  if (!std::isfinite(extent.pitch) || extent.pitch <= 0.0) {
    throw Error("synthesis: the pitch is not a positive number; give the size of a pixel");
  }
  return std::visit(
      [&](const auto& known) {
        if constexpr (Grown<std::decay_t<decltype(known)>>) {
          return surface_of(known, extent, seed);
        } else {
          return drawn(known, extent, seed);
        }
      },
      material);
}

}  // namespace hada
