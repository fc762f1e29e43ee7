#include "synth/knit.h"

#include <algorithm>

#include "synth/knit_tile.h"

namespace hada {
namespace {

float colour_of(const Knit<>& knit, int course, int channel) {
  const int index = int(knit.colour_repeat[std::size_t(course)] + 0.5);
  const auto& yarn = knit.yarns[std::size_t(std::clamp(index, 0, int(knit.yarns.size()) - 1))];
  return float(channel == 0 ? yarn.red : channel == 1 ? yarn.green : yarn.blue);
}

}  // namespace

Surface surface_of(const Knit<>& knit, const Extent& extent, Seed) {
  const KnitMaps maps = tile_maps(knit, extent);
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.height = maps.height;
  surface.normals = maps.normals;
  surface.albedo = Image(extent.rows, extent.cols, 3);
  double sum = 0.0;
  for (const float z : maps.height) sum += z;
  const float mean = float(sum / double(maps.height.size()));
  for (std::size_t k = 0; k < surface.height.size(); ++k) {
    surface.height[k] -= mean;
    for (int c = 0; c < 3 && maps.course[k] >= 0; ++c) {
      surface.albedo.planes[std::size_t(c)][k] = colour_of(knit, maps.course[k], c);
    }
  }
  return surface;
}

}  // namespace hada
