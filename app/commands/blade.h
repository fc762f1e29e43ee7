#pragma once

#include <filesystem>
#include <optional>

#include "app/terminal.h"
#include "core/random.h"
#include "synth/blade.h"

namespace hada {

struct BladeArguments {
  std::filesystem::path material;  // of forged steel
  std::filesystem::path out = "blade";
  BladeShape shape;
  HamonShape hamon{.height = 0.0};
  AyasugiShape ayasugi;
  int texture_px = 4096;     // along the blade; an eighth of it across
  std::optional<Seed> seed;  // absent: that of the file, else 0
};

/// Makes a blade of the steel that a material file describes: blade.gltf with pictures of its
/// colour, normals and roughness.
void blade_command(const BladeArguments& arguments, const Terminal& terminal);

}  // namespace hada
