#include "synth/wood.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "synth/wood_solid.h"

namespace hada {
namespace {

/// What the figure adds to the diffuse light: k_s cos^n(delta - alpha) over cos(delta), with alpha
/// the angle by which the fibre dives under the cut (Kawai, equation 4).
double figure_at(const Wood<>& wood, const WoodSolid& solid, const Cut& cut, const StemVector& at) {
  const StemVector fibre = solid.fibre_at(at), eye = cut.towards_eye();
  const double sine = -(fibre[0] * eye[0] + fibre[1] * eye[1] + fibre[2] * eye[2]);
  const double alpha = std::asin(std::clamp(sine, -1.0, 1.0));
  const double delta = wood.figure_light_rad;
  const double lobe = std::max(0.0, std::cos(delta - alpha));
  return wood.figure_specular * std::pow(lobe, wood.figure_sharpness);
}

}  // namespace

Surface surface_of(const Wood<>& wood, const Extent& extent, Seed seed, const Ripples& ripples) {
  const Cut cut = cut_of(wood);
  const WoodSolid solid(wood, seed, ripples);
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.albedo = Image(extent.rows, extent.cols, 3);
  const double lit = wood.figure_specular > 0.0 ? std::cos(wood.figure_light_rad) : 1.0;
  for_each_index(extent.rows, [&](int row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d place = extent.place(row, col);
      const StemVector at = cut.at(place.x(), place.y());
      const auto colour = solid.colour_at(solid.place_at(at), extent.pitch);
      const double shine = wood.figure_specular > 0.0 ? figure_at(wood, solid, cut, at) : 0.0;
      for (std::size_t c = 0; c < 3; ++c)
        surface.albedo.planes[c](row, col) = float(colour[c] * lit + shine);
    }
  });
  return surface;
}

Cut cut_of(const Wood<>& wood) {
  const auto vector = [](const std::vector<double>& v) { return StemVector{v[0], v[1], v[2]}; };
  return cut_along(vector(wood.cut_origin_mm), vector(wood.cut_right), vector(wood.cut_up));
}

Wood<> with_cut_moved(Wood<> wood, const std::array<double, 2>& by) {
  const StemVector centre = cut_of(wood).at(by[0], by[1]);
  wood.cut_origin_mm.assign(centre.begin(), centre.end());
  return wood;
}

}  // namespace hada
