#include "app/commands/synth.h"

#include <charconv>

#include <fmt/format.h>

#include "app/blender_script.h"
#include "app/files.h"
#include "app/material_file.h"
#include "app/materialx_file.h"
#include "app/telling.h"
#include "core/error.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "synth/knit_tile.h"
#include "synth/painted.h"
#include "synth/synthesize.h"
#include "synth/unresolved.h"

namespace hada {
namespace {

void set_size(Extent& extent, const std::string& text) {
  constexpr int most = 16384;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, extent.cols);
  const bool has_cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_cross ? std::from_chars(width.ptr + 1, end, extent.rows) : width;
  if (!has_cross || height.ec != std::errc() || height.ptr != end || extent.cols < 1 ||
      extent.rows < 1 || extent.cols > most || extent.rows > most) {
    throw Error("--size " + text + ": write width x height in pixels, such as 512x384, up to " +
                std::to_string(most) + " each");
  }
}

Extent extent_for(const SynthArguments& arguments, const MaterialFile& file) {
  Extent extent{512, 512, 0.1, file.unit};
  if (file.input) {
    extent.pitch = file.input->extent.pitch;
    if (file.input->extent.rows > 0 && file.input->extent.cols > 0) {
      extent.rows = file.input->extent.rows;
      extent.cols = file.input->extent.cols;
    }
  }
  if (arguments.pitch_mm) extent.pitch = *arguments.pitch_mm;
  if (!arguments.size_px.empty()) set_size(extent, arguments.size_px);
  return extent;
}

/// The stem that programs which carve are given; nothing if none is asked for.
std::optional<Wood<>> wood_to_carve(const SynthArguments& arguments, const Material& material) {
  if (!arguments.blender && !arguments.materialx) return {};
  const char* option = arguments.blender ? "--blender" : "--materialx";
  const auto* wood = std::get_if<Wood<>>(&material);
  if (!wood) {
    throw Error(arguments.material.string() + ": " + option + " is for wood, a solid; this is " +
                std::string(name_of(material)));
  }
  if (arguments.at.empty()) return *wood;
  return with_cut_moved(*wood, {arguments.at[0], arguments.at[1]});
}

/// The stem for other programs, with the pictures that it looks things up in.
void put_stem(Output& output, const Wood<>& wood, const Extent& extent, Seed seed,
              const SynthArguments& arguments) {
  const WoodGraph graph = wood_graph(wood, extent, seed);
  for (const auto& [name, picture] : graph.pictures) write_exr(output.file(name + ".exr"), picture);
  if (arguments.blender) put_text(output, "wood.py", blender_script(graph, wood, extent));
  if (arguments.materialx) put_text(output, "wood.mtlx", materialx_document(graph, "albedo.exr"));
}

}  // namespace

void synth_command(const SynthArguments& arguments, const Terminal& terminal) {
  const MaterialFile file = read_material(arguments.material);
  const Extent extent = extent_for(arguments, file);
  const Seed seed = arguments.seed.value_or(file.seed.value_or(1));
  const auto carved = wood_to_carve(arguments, file.material);
  terminal.step("making " + size_text(extent) + " pixels of " +
                std::string(name_of(file.material)));
  const Surface surface = painted(
      arguments.at.empty()
          ? synthesize(file.material, extent, seed)
          : synthesize_window(file.material, extent, {arguments.at[0], arguments.at[1]}, seed),
      file.mean_albedo);

  Json notes = {{"material", name_of(file.material)}, {"seed", seed}, {"version", version()}};
  if (!arguments.at.empty()) notes["window_middle"] = arguments.at;
  Output output(arguments.out);
  write_surface(output, "", surface, notes.dump(1));
  put_previews(output, "", surface);
  if (carved) put_stem(output, *carved, extent, seed, arguments);
  // Only knit has holes; a window without end has no tile to cut them from.
  if (const auto* knit = std::get_if<Knit<>>(&file.material); knit && arguments.at.empty()) {
    put_picture(output, "opacity.png", Image(tile_opacity(*knit, extent)));
  }
  // Slopes too fine for the normals scatter light as roughness does: everywhere alike.
  const auto* const wrinkle = std::get_if<Wrinkle<>>(&file.material);
  if (wrinkle && surface.has_height()) {
    const auto roughness = float(roughness_of(unresolved_slopes(*wrinkle, extent.pitch)));
    put_picture(output, "roughness.png", Image(Grid<float>(extent.rows, extent.cols, roughness)));
  }
  output.commit();

  terminal.say(fmt::format("made {} pixels of {} ({:.4g} x {:.4g} {}, seed {})", size_text(extent),
                           name_of(file.material), extent.width(), extent.height(),
                           name_of(extent.unit), seed));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(notes.dump(1));
}

}  // namespace hada
