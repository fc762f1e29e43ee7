#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"

namespace hada {

struct ValidateArguments {
  std::filesystem::path recipe;
  std::optional<std::filesystem::path> out;  // absent: only printed
  int seeds = 8;
};

/// Answers "what can my rig measure?": the errors of the whole path over several virtual captures.
void validate_command(const ValidateArguments& arguments, const Terminal& terminal);

}  // namespace hada
