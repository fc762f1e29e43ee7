#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/light_stack.h"
#include "core/random.h"
#include "core/sphere.h"
#include "core/surface.h"

namespace hada {

/// A reference sphere that lies on the virtual table.
struct TableSphere {
  SphereKind kind = SphereKind::matte;
  Eigen::Vector2d place{0.0, 0.0};  // of its centre, mm, in the frame of the picture
  double diameter_mm = 30.0;
  double albedo = 0.7;  // of a matte sphere; reflectance of a chrome one
};

/// A virtual camera straight above a dark table, with its lights and spheres.
///
/// The table is z = 0; the lowest point of the sheet and the spheres rest on it.
struct Rig {
  int rows = 600;
  int cols = 800;
  double pitch_mm = 0.2;
  Eigen::Vector2d sheet_place{0.0, 0.0};  // of the centre of the sheet, mm
  std::vector<Light> lights;              // directions, strengths; near where they have a position
  double light_diameter = 0.02;           // angle that a light is wide, radians
  std::vector<TableSphere> spheres;
  double table_albedo = 0.02;
  double ambient = 0.0;        // value of a white surface before any light is on
  double exposure = 0.8;       // value of a white sheet that faces a light of strength 1
  double read_noise = 0.0005;  // standard deviation, of the largest value
  double shot_noise = 0.002;   // standard deviation at the largest value; grows with its root
  int bits = 16;               // 8 or 16: quantised and clipped; 32: left as floats
  bool cast_shadows = true;
  Seed seed = 1;
};

/// The pictures that `rig` takes of a sheet, with their true lights; orthographic.
///
/// A matte pixel has the value exposure * albedo * (what arrives . n), 0 in the shadow, plus
/// ambient * albedo; a chrome one shows the light as a disc, the room as black and the table.
///
/// sheet    a surface with a height in mm and a pitch that divides the picture's a whole number of
///          times: each picture pixel is the mean over the finer ones it holds
/// returns  linear pictures, samples all `lit` except those a bit depth clipped; mask: the pixels
///          that lie on the sheet wholly. The rig's ambient is not taken off: lights of strength 0
///          give the picture of it
/// throws   Error if the sheet does not fit into the picture, or the pitches do not divide
LightStack photograph(const Surface& sheet, const Rig& rig);

/// The surface that a perfect reconstruction of these pictures would return, on their lattice: the
/// mean of the fine height, normals and albedo over each pixel, cropped to the sheet.
Surface seen(const Surface& sheet, const Rig& rig);

}  // namespace hada
