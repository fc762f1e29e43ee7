#pragma once

#include <string>
#include <vector>

#include "app/material_file.h"

namespace hada {

/// A parameter of a material file as a person reads it.
struct ParameterRow {
  std::string name;     // path of the field or word
  std::string number;   // "0.313 ± 0.035", or with its 95 % interval; alone where neither is told
  std::string unit;     // of the surface it was fitted to: "mm", or "px" for "mm"
  std::string meaning;  // with a note where the fit ended on a bound
};

/// Words first, then the fields in the order of their table.
std::vector<ParameterRow> parameter_rows(const MaterialFile& file);

}  // namespace hada
