#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/prior_file.h"
#include "app/terminal.h"

namespace hada {

struct ReconstructArguments {
  std::filesystem::path capture;
  std::filesystem::path out;
  std::optional<std::filesystem::path> lights;
  std::optional<double> pitch_mm;  // overrides the manifest
  std::string levelling = "plane";
  PriorArguments prior;
  std::string estimator = "adaptive";
  bool labels = false;  // whether a picture of every light says what became of each sample
};

/// Turns a capture into a surface folder with previews.
void reconstruct_command(const ReconstructArguments& arguments, const Terminal& terminal);

}  // namespace hada
