#pragma once

#include <filesystem>
#include <vector>

#include "app/terminal.h"

namespace hada {

struct ContactArguments {
  std::vector<std::filesystem::path> materials;
  std::filesystem::path out = "contact.png";
  int columns = 2;
  int width_px = 600;  // of one picture, at most
};

/// Puts what material files describe side by side, row by row: each at the size and with the seed
/// of its file, shrunk, as bright as an eye likes it.
void contact_command(const ContactArguments& arguments, const Terminal& terminal);

}  // namespace hada
