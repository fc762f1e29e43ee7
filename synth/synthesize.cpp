#include "synth/synthesize.h"

#include <cmath>
#include <variant>

#include "core/error.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr float plain_albedo = 0.8f;

template <Spectral M>
Grid<float> height_of(const M& material, const Extent& extent, Seed seed) {
  return gaussian_field([&](double fx, double fy) { return psd(material, fx, fy); }, extent, seed);
}

}  // namespace

Surface synthesize(const Material& material, const Extent& extent, Seed seed) {
  if (extent.rows < 1 || extent.cols < 1) {
    throw Error("synthesis: the surface has no pixels; ask for at least 1 x 1");
  }
  if (!std::isfinite(extent.pitch) || extent.pitch <= 0.0) {
    throw Error("synthesis: the pitch is not a positive number; give the size of a pixel");
  }
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.height =
      std::visit([&](const auto& known) { return height_of(known, extent, seed); }, material);
  surface.normals = normals_of(surface.height, surface.mask, extent.pitch);
  surface.albedo = Image(Grid<float>(extent.rows, extent.cols, plain_albedo));
  return surface;
}

}  // namespace hada
