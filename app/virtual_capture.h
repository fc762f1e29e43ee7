#pragma once

#include <filesystem>

#include "app/recipe.h"
#include "capture/load.h"
#include "core/light_stack.h"
#include "core/surface.h"

namespace hada {

/// What a virtual camera took, and what was really there.
struct VirtualCapture {
  LightStack stack;  // the pictures, with their true lights
  Surface truth;     // what a perfect reconstruction would return
};

/// Makes the sheet of the recipe, finer than it will be seen, and photographs it.
VirtualCapture virtual_capture(const Recipe& recipe);

/// The same pictures as `load_photographs` would return them: nothing of the truth is left.
Photographs as_loaded(const VirtualCapture& capture, const Recipe& recipe);

/// Writes the pictures and capture.json into `folder`, and the truth into `folder/truth`: a surface
/// folder with lights.json and material.json.
void write_capture(const std::filesystem::path& folder, const VirtualCapture& capture,
                   const Recipe& recipe);

}  // namespace hada
