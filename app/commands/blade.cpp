#include "app/commands/blade.h"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "app/draw/maps.h"
#include "app/files.h"
#include "app/material_file.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/srgb.h"
#include "io/mesh_file.h"
#include "io/output.h"
#include "synth/forged.h"

namespace hada {
namespace {

constexpr float iron[3] = {0.56f, 0.57f, 0.58f};  // reflectance of iron at normal incidence
constexpr float dark_grain = 0.25f;               // share that the darkest grain takes from it
constexpr double polished = 0.03;                 // roughness of the paper's blade
constexpr float hardened_roughness = 0.22f;       // of the edge, which is not polished alike
constexpr float hardened_bright = 1.12f;

/// The etched grain of the picture of one side, in waves if asked for: 0 to 1.
Grid<float> grain_of(const Forged<>& forged, const AyasugiShape& shape, int rows, int cols,
                     Seed seed) {
  auto block = forged_block(forged, divisible({rows, cols}, forged.sequence), seed);
  block = ayasugi(block, shape);
  quantise(block, 1.0, forged.step / forged.levels);
  return crop(block, 0, 0, rows, cols);
}

Image colour_picture(const Grid<float>& grain, const Grid<float>& hard) {
  Image picture(grain.rows(), grain.cols(), 3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < grain.size(); ++k) {
      const float bright = 1.0f - dark_grain * (1.0f - grain[k]);
      const float whiter = 1.0f + (hardened_bright - 1.0f) * hard[k];
      picture.planes[c][k] = srgb_from_linear(std::min(1.0f, iron[c] * bright * whiter));
    }
  }
  return picture;
}

/// As glTF wants it: roughness in green, metallic in blue, both times their factor.
Image roughness_picture(const Grid<float>& grain, const Grid<float>& hard) {
  Image picture(grain.rows(), grain.cols(), 3);
  for (std::size_t k = 0; k < grain.size(); ++k) {
    const float etched = float(polished) * (1.0f + 0.5f * (1.0f - grain[k]));
    picture.planes[1][k] = etched + hard[k] * (hardened_roughness - etched);
    picture.planes[2][k] = 1.0f;
  }
  return picture;
}

}  // namespace

void blade_command(const BladeArguments& arguments, const Terminal& terminal) {
  const MaterialFile file = read_material(arguments.material);
  const auto* forged = std::get_if<Forged<>>(&file.material);
  if (!forged) {
    throw Error(arguments.material.string() +
                ": a blade is made of forged steel; name a material file of \"forged\"");
  }
  const Seed seed = arguments.seed.value_or(file.seed.value_or(0));
  const int cols = arguments.texture_px, rows = std::max(cols / 8, 1);
  terminal.step("forging");
  Surface side;
  side.extent = {rows, cols, arguments.shape.length_mm / cols, Unit::mm};
  side.mask = full_mask(side.extent);
  const Grid<float> grain = grain_of(*forged, arguments.ayasugi, rows, cols, seed);
  const Grid<float> hard = hamon_mask(rows, cols, arguments.hamon, seed);
  side.height = grain;
  for (float& height : side.height) height *= float(forged->etch_mm);
  side.normals = normals_of(side.height, side.mask, side.extent.pitch);

  terminal.step("writing the blade");
  // The picture of the hardened edge has its own roughness; without one the factor is the paper's.
  const bool rough = arguments.hamon.height > 0.0;
  Output output(arguments.out);
  put_picture(output, "colour.png", colour_picture(grain, hard));
  put_picture(output, "normal.png", normal_picture(side));
  if (rough) put_picture(output, "roughness.png", roughness_picture(grain, hard));
  write_mesh(output, "blade.gltf", blade_mesh(arguments.shape),
             {.base_color = "colour.png",
              .normal = "normal.png",
              .metallic_roughness = rough ? "roughness.png" : "",
              .metallic = 1.0,
              .roughness = rough ? 1.0 : polished});
  output.commit();
  terminal.say(fmt::format("made a blade of {:.0f} mm, folded {} (seed {})",
                           arguments.shape.length_mm, forged->sequence, seed));
  terminal.say("wrote " + (arguments.out / "blade.gltf").string());
}

}  // namespace hada
