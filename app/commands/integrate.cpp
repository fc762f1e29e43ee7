#include "app/commands/integrate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "app/files.h"
#include "app/telling.h"
#include "core/bounding_box.h"
#include "core/error.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/normal_file.h"
#include "io/surface_file.h"
#include "reconstruct/integrate.h"
#include "reconstruct/level.h"

namespace hada {
namespace {

std::ptrdiff_t pixels_in(const Mask& mask) {
  return std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
}

// A picture of one plane, or the mean of three, of the size of the normal map.
Grid<float> read_plane(const std::filesystem::path& path, const Mask& size) {
  const Image image = read_image(path).image;
  Grid<float> plane = image.planes[0];
  if (!plane.same_size(size)) {
    throw Error(fmt::format("{}: is {} x {} pixels, but the normal map {} x {}", path.string(),
                            plane.cols(), plane.rows(), size.cols(), size.rows()));
  }
  for (std::size_t i = 0; i < plane.size() && image.planes.size() == 3; ++i) {
    plane[i] = (image.planes[0][i] + image.planes[1][i] + image.planes[2][i]) / 3.0f;
  }
  return plane;
}

Levelling levelling_named(const std::string& name) {
  if (name == "plane") return Levelling::plane;
  return name == "quadratic" ? Levelling::quadratic : Levelling::offset;
}

Jumps jumps_named(const std::string& name) {
  if (name == "none") return Jumps::none;
  return name == "allowed" ? Jumps::allowed : Jumps::automatic;
}

void keep(Mask& mask, const Grid<float>& plane, float above) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!(plane[i] > above)) mask[i] = 0;
  }
}

// What lies where, before anything is integrated.
struct Input {
  Surface surface;
  IntegrateOptions options;
  double share_without_normal = 0.0;  // of the pixels that the mask asks for
};

Input read_input(const IntegrateArguments& arguments) {
  NormalFile file = read_normals(arguments.normals, arguments.y_down);
  Input input;
  if (arguments.mask) {
    Mask asked(file.mask.rows(), file.mask.cols(), 1);
    keep(asked, read_plane(*arguments.mask, file.mask), 0.5f);
    for (std::size_t i = 0; i < asked.size(); ++i) file.mask[i] = file.mask[i] && asked[i];
    const auto pixels = double(pixels_in(asked));
    if (pixels > 0.0) input.share_without_normal = 1.0 - double(pixels_in(file.mask)) / pixels;
  }
  Grid<float> weight;
  if (arguments.weights) {
    weight = read_plane(*arguments.weights, file.mask);
    keep(file.mask, weight, 0.0f);
    for (float& w : weight) w = std::isfinite(w) && w > 0.0f ? w : 1.0f;
  }
  if (pixels_in(file.mask) == 0) {
    throw Error(arguments.normals.string() +
                ": no pixel is left that has a normal and is in the mask; check the mask");
  }
  const auto [row, col, rows, cols] = bounding_box(file.mask);
  Surface& surface = input.surface;
  surface.extent = {.rows = rows, .cols = cols};
  if (arguments.pitch_mm) {
    surface.extent.pitch = *arguments.pitch_mm;
    surface.extent.unit = Unit::mm;
  }
  surface.mask = crop(file.mask, row, col, rows, cols);
  surface.normals = crop(file.normals, row, col, rows, cols);
  surface.offset_px = {col, row};
  input.options.weight = crop(weight, row, col, rows, cols);
  if (arguments.intrinsics) {
    const Eigen::Matrix3d k = read_intrinsics(*arguments.intrinsics);
    input.options.pin_hole =
        PinHole{{k(0, 0), k(1, 1)},
                {k(0, 2) + 0.5 - surface.offset_px.x(), k(1, 2) + 0.5 - surface.offset_px.y()}};
  }
  return input;
}

// D - z: along the optical axis, in units of the height.
Image depth_of(const Surface& surface, const PinHole& pin_hole) {
  Image depth(surface.extent.rows, surface.extent.cols, 1);
  const double distance = pin_hole.focal_px.x() * surface.extent.pitch;
  for (std::size_t i = 0; i < surface.height.size(); ++i) {
    depth.planes[0][i] = surface.mask[i] ? float(distance - surface.height[i]) : std::nanf("");
  }
  return depth;
}

std::string notes_of(const Input& input, const Integrated& found) {
  Json notes = {{"integration", found.may_jump ? "edge-aware" : "least squares"},
                {"reason", found.reason},
                {"projection", input.options.pin_hole ? "pin-hole" : "orthographic"},
                {"weighted", !input.options.weight.empty()},
                {"version", version()}};
  return notes.dump(1);
}

}  // namespace

void integrate_command(const IntegrateArguments& arguments, const Terminal& terminal) {
  Output output(arguments.out);
  terminal.step("reading the normal map");
  Input input = read_input(arguments);
  Surface& surface = input.surface;
  terminal.step("integrating");
  const Integrated found = integrate_with_jumps(surface.normals, surface.mask, surface.extent.pitch,
                                                jumps_named(arguments.jumps), input.options);
  surface.height = found.height;
  if (input.options.pin_hole) {
    write_exr(output.file("depth.exr"), depth_of(surface, *input.options.pin_hole));
  }
  const Levelling levelling = levelling_named(arguments.levelling);
  level(surface.height, surface.mask, levelling);
  surface.levelling = name_of(levelling);

  const std::string notes = notes_of(input, found);
  write_surface(output, "", surface, notes);
  put_previews(output, "", surface);
  output.commit();

  terminal.say(fmt::format("{} pixels, {} of them in the mask: {}", size_text(surface.extent),
                           pixels_in(surface.mask),
                           found.may_jump ? "a height that may jump" : "least-squares height"));
  terminal.say("because " + found.reason);
  if (input.share_without_normal > 0.0) {
    terminal.say(fmt::format("note: {:.2g} % of the mask holds no normal and is left out",
                             100.0 * input.share_without_normal));
  }
  terminal.say("wrote " + arguments.out.string());
  terminal.result(notes);
}

}  // namespace hada
