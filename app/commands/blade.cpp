#include "app/commands/blade.h"

#include <variant>

#include <fmt/format.h>

#include "app/blade_side.h"
#include "app/draw/maps.h"
#include "app/files.h"
#include "app/material_file.h"
#include "core/error.h"
#include "core/srgb.h"
#include "io/mesh_file.h"
#include "io/output.h"

namespace hada {
namespace {

constexpr double polished = 0.03;            // roughness of the paper's blade
constexpr float hardened_roughness = 0.22f;  // of the edge, which is not polished alike

Image colour_picture(Image linear) {
  for (auto& plane : linear.planes) {
    for (float& value : plane) value = srgb_from_linear(value);
  }
  return linear;
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
  terminal.step("forging");
  const BladeSide side = blade_side(*forged, arguments.shape.length_mm, arguments.texture_px,
                                    {arguments.hamon, arguments.ayasugi}, seed);

  terminal.step("writing the blade");
  // The picture of the hardened edge has its own roughness; without one the factor is the paper's.
  const bool rough = arguments.hamon.height > 0.0;
  Output output(arguments.out);
  put_picture(output, "colour.png", colour_picture(side.surface.albedo));
  put_picture(output, "normal.png", normal_picture(side.surface));
  if (rough) put_picture(output, "roughness.png", roughness_picture(side.grain, side.hard));
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
