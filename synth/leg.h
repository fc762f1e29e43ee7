#pragma once

#include "core/mesh.h"

namespace hada {

/// The shape of a leg from above the ankle to the thigh, by its girths, and of its foot; the
/// defaults are those of a grown woman, whose foot is 230 mm long.
struct LegShape {
  double length_mm = 700.0;
  double ankle_mm = 210.0;  // girths, at 0
  double calf_mm = 350.0;   // at 0.33 of the length
  double knee_mm = 360.0;   // at 0.55
  double thigh_mm = 540.0;  // at 1
  double bend_mm = 14.0;    // how far the calf lies behind the line from ankle to thigh
  double foot_mm = 0.0;     // from heel to toe; 0: the leg ends above the ankle
  int rings = 160;          // along the leg
  int segments = 96;        // around it
};

/// A closed mesh of the leg, standing upright: ankle at y = 0, thigh at +y, shin and toes towards
/// +z, and a sole 0.39 of the foot's length below the ankle.
TriangleMesh leg_mesh(const LegShape& shape = {});

}  // namespace hada
