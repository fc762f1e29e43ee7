#include "synth/wood.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "synth/wood_solid.h"

namespace hada {
namespace {

StemVector unit(const StemVector& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

StemVector cross(const StemVector& a, const StemVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const StemVector& a, const StemVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The plane of the cut, its two directions at right angles.
struct Cut {
  StemVector origin, right, up, towards_eye;
};

Cut cut_of(const Wood<>& wood) {
  const auto vector = [](const std::vector<double>& v) { return StemVector{v[0], v[1], v[2]}; };
  Cut cut{vector(wood.cut_origin_mm), vector(wood.cut_right), vector(wood.cut_up), {}};
  const StemVector across = cross(cut.right, cut.up);
  if (!(dot(across, across) > 1e-12 * dot(cut.right, cut.right) * dot(cut.up, cut.up))) {
    throw Error(
        "wood: cut_right and cut_up do not span a plane; give two directions that are not "
        "parallel");
  }
  cut.towards_eye = unit(across);
  cut.right = unit(cut.right);
  cut.up = cross(cut.towards_eye, cut.right);
  return cut;
}

/// What the figure adds to the diffuse light: k_s cos^n(delta - alpha) over cos(delta), with alpha
/// the angle by which the fibre dives under the cut (Kawai, equation 4).
double figure_at(const Wood<>& wood, const WoodSolid& solid, const Cut& cut, const StemVector& at) {
  const double sine = -dot(solid.fibre_at(at), cut.towards_eye);
  const double alpha = std::asin(std::clamp(sine, -1.0, 1.0));
  const double delta = wood.figure_light_rad;
  const double lobe = std::max(0.0, std::cos(delta - alpha));
  return wood.figure_specular * std::pow(lobe, wood.figure_sharpness);
}

}  // namespace

Surface surface_of(const Wood<>& wood, const Extent& extent, Seed seed) {
  const Cut cut = cut_of(wood);
  const WoodSolid solid(wood, seed);
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.albedo = Image(extent.rows, extent.cols, 3);
  const double lit = wood.figure_specular > 0.0 ? std::cos(wood.figure_light_rad) : 1.0;
  for_each_index(extent.rows, [&](int row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d place = extent.place(row, col);
      StemVector at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = cut.origin[k] + place.x() * cut.right[k] + place.y() * cut.up[k];
      const auto colour = solid.colour_at(solid.place_at(at), extent.pitch);
      const double shine = wood.figure_specular > 0.0 ? figure_at(wood, solid, cut, at) : 0.0;
      for (std::size_t c = 0; c < 3; ++c)
        surface.albedo.planes[c](row, col) = float(colour[c] * lit + shine);
    }
  });
  return surface;
}

Wood<> with_cut_moved(Wood<> wood, const std::array<double, 2>& by) {
  const Cut cut = cut_of(wood);
  for (std::size_t k = 0; k < 3; ++k)
    wood.cut_origin_mm[k] = cut.origin[k] + by[0] * cut.right[k] + by[1] * cut.up[k];
  return wood;
}

}  // namespace hada
