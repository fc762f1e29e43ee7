#pragma once

#include <filesystem>

#include "app/terminal.h"

namespace hada {

struct PhotographArguments {
  std::filesystem::path recipe;
  std::filesystem::path out;
};

/// Photographs a virtual sheet: a capture folder with its truth beside it.
void photograph_command(const PhotographArguments& arguments, const Terminal& terminal);

}  // namespace hada
