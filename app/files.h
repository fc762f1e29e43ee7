#pragma once

#include <filesystem>
#include <string>

#include "core/surface.h"
#include "io/output.h"

namespace hada {

/// Puts a text into `output` as `name`.
void put_text(Output& output, const std::string& name, const std::string& text);

/// Puts an 8-bit PNG into `output` as `name`.
void put_picture(Output& output, const std::string& name, const Image& picture);

/// Puts what a person looks at first beside a surface: height.png (shaded), normal.png, albedo.png,
/// each where the surface has it, and shrunk where a side is longer than 8192 px. folder: inside
/// the output, "" or "surface/".
void put_previews(Output& output, const std::string& folder, const Surface& surface);

/// Where the file `data_synthetic/name` lies: beside an installed program, or in the source tree.
/// throws  Error if it is in neither
std::filesystem::path shipped_recipe(const std::string& name);

/// "0.1.0"
std::string version();

}  // namespace hada
