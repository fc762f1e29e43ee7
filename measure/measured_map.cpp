#include "measure/measured_map.h"

#include "core/srgb.h"

namespace hada {

Grid<float> measured_map(const Surface& surface) {
  if (surface.has_height()) return surface.height;
  Grid<float> brightness = luminance(surface.albedo);
  for (float& value : brightness) value = srgb_from_linear(value);
  return brightness;
}

}  // namespace hada
