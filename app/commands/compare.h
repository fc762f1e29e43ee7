#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct CompareArguments {
  std::filesystem::path first;
  std::filesystem::path second;
  std::optional<std::filesystem::path> out;  // absent: only printed
  std::optional<double> pitch_mm;
};

/// Says how far two surfaces differ, pixel by pixel and in their statistics.
void compare_command(const CompareArguments& arguments, const Terminal& terminal);

}  // namespace hada
