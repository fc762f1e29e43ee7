#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct DemoArguments {
  std::filesystem::path out = "out/demo";
  std::optional<std::filesystem::path> recipe;  // absent: the sheet and spheres that are shipped
};

/// Photographs a virtual sheet, walks the whole path and compares what it found with the truth.
void demo_command(const DemoArguments& arguments, const Terminal& terminal);

}  // namespace hada
