#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera.h"
#include "core/surface.h"

namespace hada {

/// Slopes dz/dx and dz/dy of a height, y up.
using SlopeMap = Grid<Eigen::Vector2f>;

/// A pin-hole camera, in pixels of a normal map.
struct PinHole {
  Eigen::Vector2d focal_px;  // along u and v, > 0
  Eigen::Vector2d
      centre_px;  // (u, v) of the optical axis, the centre of the first pixel (0.5, 0.5)
};

/// The pin-hole of `camera` for the part of its picture that begins at pixel `offset_px` (u, v);
/// nothing for an orthographic one.
std::optional<PinHole> pin_hole_of(const Camera& camera, const Eigen::Vector2i& offset_px);

/// Cosine of a normal to the ray, below which a slope means nothing.
constexpr float least_facing = 0.02f;

/// The slopes of unit normals with z > 0; 0 outside the mask.
///
/// With a pin-hole they are those of w = -D log(1 - z / D), D = focal_px.x() * pitch, by the place
/// (x, y) of a pixel on the plane z = 0. From n . dP = 0 with P = (1 - z / D) (x, y, -D) + (0, 0,
/// D):
///
///     dw/dx = -nx / m,  dw/dy = -ny / m,  m = nz - (nx x + ny y) / D
///
/// so w is found as a height is. A normal with m below `least`, all but hidden from the pin-hole,
/// counts as if m were `least`.
SlopeMap slopes_of(const NormalMap& normals, const Mask& mask,
                   const std::optional<PinHole>& pin_hole = {}, float least = least_facing);

/// m of `slopes_of`, the cosine between normal and ray but for its length: n_z without a pin-hole.
Grid<float> facing_of(const NormalMap& normals, const Mask& mask,
                      const std::optional<PinHole>& pin_hole = {}, float least = least_facing);

/// The largest angle between the optical axis and the ray to a pixel of the mask's frame, degrees.
double farthest_off_axis_deg(const PinHole& pin_hole, const Mask& mask);

/// Of the pixels of a mask, those whose normal looks away from the pin-hole by more than 6 degrees:
/// none can be seen, so either normal or pin-hole is wrong.
double share_hidden(const NormalMap& normals, const Mask& mask, const PinHole& pin_hole);

/// z = D (1 - exp(-w / D)), in place, for w, z and D in one unit.
void height_from_log_depth(Grid<float>& w, double distance);

}  // namespace hada
