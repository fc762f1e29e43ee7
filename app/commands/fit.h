#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/terminal.h"

namespace hada {

struct FitArguments {
  std::string material;
  std::filesystem::path input;  // surface folder, height map or picture
  std::filesystem::path out = "material.json";
  std::optional<double> pitch_mm;
  int components = 0;  // 0: the data decide
};

/// Finds the parameters of a material that explain a surface.
void fit_command(const FitArguments& arguments, const Terminal& terminal);

}  // namespace hada
