#pragma once

#include <utility>

#include "core/srgb.h"
#include "core/surface.h"
#include "synth/gaussian_field.h"

namespace hada {

/// A picture whose brightness has that spectrum about a mean of 1/2, 256 x 256 pixels of 0.1 mm. It
/// does not tile: it is cut from a larger field.
template <class Psd>
Surface cut_picture(const Psd& psd, Seed seed) {
  const Extent world{.rows = 400, .cols = 400, .pitch = 0.1, .unit = Unit::mm};
  Surface surface;
  surface.extent = {.rows = 256, .cols = 256, .pitch = 0.1, .unit = Unit::mm};
  surface.mask = full_mask(surface.extent);
  auto brightness = crop(gaussian_field(psd, world, seed), 0, 0, 256, 256);
  for (float& value : brightness) value = linear_from_srgb(0.5f + value);
  surface.albedo = Image(std::move(brightness));
  return surface;
}

}  // namespace hada
