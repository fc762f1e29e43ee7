#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"
#include "app/whole_path.h"

namespace hada {

struct RunArguments {
  std::filesystem::path capture;
  std::filesystem::path out = "out";
  std::optional<std::filesystem::path> lights;
  std::optional<double> pitch_mm;  // overrides the manifest
  WholePathOptions path;
};

/// All steps from a capture to a new surface, and the report.
void run_command(const RunArguments& arguments, const Terminal& terminal);

}  // namespace hada
