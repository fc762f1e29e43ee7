#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/terminal.h"

namespace hada {

struct BlockArguments {
  std::filesystem::path block;
  std::filesystem::path out = "block";
  std::vector<std::string> left_out;  // names of faces
};

/// Finds the one stem that all faces of a block are cut from, and predicts cuts of it.
void block_command(const BlockArguments& arguments, const Terminal& terminal);

}  // namespace hada
