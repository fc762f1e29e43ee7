#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/light_stack.h"
#include "core/sphere.h"

namespace hada {

/// Lights as they are kept in a file (`"hada": "lights/1"`), with the spheres they were read from.
struct LightsFile {
  std::vector<Light> lights;
  std::vector<Sphere> spheres;
  std::vector<LightErrorMode> errors;  // how the lights may be wrong together; empty: not said
  Unit position_unit = Unit::mm;       // of near lights: px if they were found without a pitch
  bool strengths_measured = true;      // false: they are assumed equal, only directions were seen
  std::vector<std::vector<Eigen::Vector2d>> highlights_px = {};  // of each light, where spheres
                                                                 // show it: (u, v); empty: not said
  std::string encoding;  // of the pictures they were found in, "linear" or "srgb"; empty: not said
};

/// The lights in a file: one of ours, or a light-position file if its name ends in `.lp`.
///
/// throws  Error naming the file and the key for anything that is not a lights file: unknown or
///         missing keys, other schema, a direction that is not finite or has no length; or as
///         `read_lp` does
LightsFile read_lights(const std::filesystem::path& path);

/// The text of a lights file: strengths as one number where the channels are equal, else [r, g, b].
std::string lights_text(const LightsFile& file);

}  // namespace hada
