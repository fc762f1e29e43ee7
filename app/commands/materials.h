#pragma once

#include <string>

#include "app/terminal.h"

namespace hada {

struct MaterialsArguments {
  std::string name;       // empty: all
  bool markdown = false;  // as docs/materials.md
};

/// Prints the field tables of the materials: names, units, bounds and meanings.
void materials_command(const MaterialsArguments& arguments, const Terminal& terminal);

}  // namespace hada
