#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct FigureArguments {
  std::filesystem::path capture;
  std::filesystem::path out = "figure";
  std::optional<std::filesystem::path> lights;
  std::optional<double> pitch_mm;
  double trunk_deg = 90.0;
};

/// Reads the figure of a polished cut of wood from photographs under several lights: gloss and
/// sharpness of the wood, colourless albedo and dive of the fibres at every pixel.
void figure_command(const FigureArguments& arguments, const Terminal& terminal);

}  // namespace hada
