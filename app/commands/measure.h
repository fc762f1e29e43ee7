#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct MeasureArguments {
  std::filesystem::path input;               // surface folder, height map or picture
  std::optional<std::filesystem::path> out;  // absent: only printed
  std::optional<double> pitch_mm;
};

/// Describes a surface by its spectrum, rings, sectors and roughness.
void measure_command(const MeasureArguments& arguments, const Terminal& terminal);

}  // namespace hada
