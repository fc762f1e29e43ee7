#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct ClassifyArguments {
  std::filesystem::path input;  // surface folder, height map or picture
  std::filesystem::path among;  // folder of wrinkle files; empty: the seven papers that ship
  std::optional<std::filesystem::path> out;  // JSON file
  std::optional<double> pitch_mm;
};

/// Says which of several kinds of sheet a measured one is like.
void classify_command(const ClassifyArguments& arguments, const Terminal& terminal);

}  // namespace hada
