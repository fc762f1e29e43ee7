#pragma once

#include <filesystem>
#include <string>

#include "capture/photograph.h"
#include "core/extent.h"
#include "core/random.h"
#include "synth/material.h"

namespace hada {

/// A capture that never was (`"hada": "recipe/1"`): what lies on the table, and how it is looked
/// at.
struct Recipe {
  std::string name;  // as the file says, else that of the file
  Material material;
  Extent sheet;  // of the fine lattice: the pitch of the picture over the oversampling
  Seed sheet_seed = 1;
  Rig rig;
};

/// throws  Error naming the file and the key for unknown or missing keys and values that no rig has
Recipe read_recipe(const std::filesystem::path& path);

}  // namespace hada
