#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/surface.h"
#include "io/lights_file.h"
#include "io/output.h"

namespace hada {

/// Puts a surface into `output`: surface.json, height.exr, normal.exr, albedo.exr, mask.png,
/// normal_sigma.exr, height_sigma.exr, each where the surface has it; outside the mask floats are
/// NaN.
///
/// folder      inside the output, "" or "surface/"
/// notes_json  the text of a JSON object with what else should be remembered (noise, remarks, ...),
///             stored under "notes"; may be empty
void write_surface(Output& output, const std::string& folder, const Surface& surface,
                   const std::string& notes_json = "");

enum class SurfaceMaps {
  all,
  height_alone  // of a surface with a height nothing else: no normals, albedo or sigma
};

/// A surface folder; or a height map (one float channel, in mm where `pitch_mm` is given, else in
/// px); or a plain picture (anything else), which becomes a linear albedo without a height.
///
/// pitch_mm  overrides what the folder says
/// throws    Error naming the file for anything that cannot be one of these
Surface read_surface(const std::filesystem::path& path, std::optional<double> pitch_mm = {},
                     SurfaceMaps maps = SurfaceMaps::all);

}  // namespace hada
