#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/prior_file.h"
#include "app/terminal.h"

namespace hada {

struct IntegrateArguments {
  std::filesystem::path normals;
  std::filesystem::path out;
  std::optional<std::filesystem::path> mask;
  std::optional<std::filesystem::path> intrinsics;
  std::optional<std::filesystem::path> weights;
  std::string normal_sigma;  // degrees, or the name of a map in radians; empty: not known
  std::optional<double> pitch_mm;
  bool y_down = false;
  std::string jumps = "automatic";
  std::string levelling = "offset";
  PriorArguments prior;
  std::string memory = "automatic";  // ram or disk
};

/// Turns a normal map of another program into a surface folder.
void integrate_command(const IntegrateArguments& arguments, const Terminal& terminal);

}  // namespace hada
