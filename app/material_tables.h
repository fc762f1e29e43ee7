#pragma once

#include <string>

namespace hada {

/// The field tables of all materials, or of one, with the defaults: JSON of kind materials/1.
/// throws  Error that lists the names if there is no such material
std::string material_tables_text(const std::string& only = "");

}  // namespace hada
