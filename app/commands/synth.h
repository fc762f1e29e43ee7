#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"
#include "core/random.h"

namespace hada {

struct SynthArguments {
  std::filesystem::path material;
  std::filesystem::path out;
  std::string size_px;             // "512x384"; empty: that of the fitted surface, else 512x512
  std::optional<double> pitch_mm;  // absent: that of the fitted surface, else 0.1
  std::optional<Seed> seed;        // absent: that of the file, else 1
  std::vector<double> at;  // middle of a window of an endless surface; empty: one that tiles
  bool blender = false;    // also write wood as a script for Blender, with its pictures
  bool materialx = false;  // also write wood as a MaterialX document, with its pictures
};

/// Makes more of the surface that a material file describes.
void synth_command(const SynthArguments& arguments, const Terminal& terminal);

}  // namespace hada
