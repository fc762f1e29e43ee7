#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"
#include "capture/calibrate.h"
#include "capture/load.h"
#include "core/light_stack.h"
#include "io/lights_file.h"

namespace hada {

/// Photographs whose lights are known, and where that knowledge came from.
struct LitCapture {
  Photographs photographs;                 // without the pictures: those are in the stack
  LightsFile lights;                       // in force, and the spheres that they were read off
  std::vector<Sphere> spheres;             // in these pictures
  std::optional<Calibration> calibration;  // absent where the lights were given
  LightStack stack;
  std::string source;  // "the spheres in the pictures", "lights.json", "the manifest"
  std::vector<std::string> remarks;
};

/// Loads the pictures in `folder`. A pitch given here overrides that of the manifest.
Photographs load_folder(const std::filesystem::path& folder, const Terminal& terminal,
                        std::optional<double> pitch_mm = {});

/// Lights a set of photographs: from `lights_path` if there is one, else as their manifest says,
/// else read off the spheres in them.
LitCapture lit_capture(Photographs photographs,
                       const std::optional<std::filesystem::path>& lights_path,
                       const Terminal& terminal);

/// What a calibration leaves on disk. unit: of the pictures
LightsFile lights_file(const Calibration& calibration, Unit unit);

}  // namespace hada
