#pragma once

#include <filesystem>

#include "app/terminal.h"

namespace hada {

struct CalibrateArguments {
  std::filesystem::path capture;
  std::filesystem::path out = "lights.json";
};

/// Reads the lights off the spheres in a capture and writes them to a lights file.
void calibrate_command(const CalibrateArguments& arguments, const Terminal& terminal);

}  // namespace hada
