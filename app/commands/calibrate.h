#pragma once

#include <filesystem>
#include <vector>

#include "app/terminal.h"
#include "io/capture_file.h"

namespace hada {

struct CalibrateArguments {
  std::filesystem::path capture;
  std::filesystem::path out = "lights.json";
  std::vector<BoxPx> boxes;  // where the spheres are; none: as the manifest says, or anywhere
};

/// Reads the lights off the spheres in a capture and writes them to a lights file.
void calibrate_command(const CalibrateArguments& arguments, const Terminal& terminal);

}  // namespace hada
