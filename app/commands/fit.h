#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"

namespace hada {

struct FitArguments {
  std::string material;
  std::filesystem::path input;  // surface folder, height map or picture
  std::filesystem::path out = "material.json";
  std::optional<double> pitch_mm;
  int components = 0;              // 0: the data decide
  double lens_blur_px = 0.0;       // of wrinkles: standard deviation of the lens's point spread
  bool ridges = false;             // of wrinkles: whether skew, tail and sharpness are found too
  std::string view = "automatic";  // or, of wood, end-grain or face; of forged steel, block
  std::filesystem::path report;    // of forged steel: page to write; may be empty
  std::filesystem::path face;      // of wood: picture of the tangential face; may be empty
  // Of knit: photographs of one piece, each pulled to a stretch; may be none.
  std::vector<std::filesystem::path> pulled;
  std::vector<double> stretches;
  std::string along = "wale";
  std::string clamp = "three-points";
  int courses = 0;  // of the piece, clamped ones included
  int wales = 0;
  std::filesystem::path crossings;  // folder to write what was tracked into; may be empty
};

/// Finds the parameters of a material that explain a surface.
void fit_command(const FitArguments& arguments, const Terminal& terminal);

}  // namespace hada
