#include "app/commands/integrate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/files.h"
#include "app/telling.h"
#include "core/bounding_box.h"
#include "core/error.h"
#include "io/disk_memory.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/normal_file.h"
#include "io/surface_file.h"
#include "reconstruct/height_sigma.h"
#include "reconstruct/integrate.h"
#include "reconstruct/level.h"
#include "reconstruct/remarks.h"
#include "reconstruct/slopes.h"
#include "reconstruct/turned_y.h"

namespace hada {
namespace {

std::ptrdiff_t pixels_in(const Mask& mask) {
  return std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
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

// Above, about 60 bytes for each pixel are more than can be counted on to be free.
constexpr std::size_t most_in_ram = std::size_t(1) << 26;

void require_bright_pixel(const std::filesystem::path& path, const Grid<float>& picture,
                          const Mask& asked) {
  if (pixels_in(asked) > 0) return;
  float brightest = 0.0f;
  for (const float value : picture) brightest = std::max(brightest, value);
  throw Error(fmt::format(
      "{}: no pixel of this mask is brighter than half, the brightest is {:.2g} of white; paint "
      "white what counts",
      path.string(), brightest));
}

// What lies where, before anything is integrated.
struct Input {
  Surface surface;
  IntegrateOptions options;
  double share_without_normal = 0.0;  // of the pixels that the mask asks for
  double share_without_weight = 0.0;  // of those with a normal: 0, below, or no number
  double share_away = 0.0;            // as of `NormalFile`
  double share_off_length = 0.0;
  Extent frame;  // of the whole normal map
  PixelBox box;  // what the surface is of it
};

// A part of a map that lies where the map does, or the map itself if that is all of it.
template <class T>
Grid<T> cut(Grid<T> map, const PixelBox& box) {
  if (map.rows() == box.rows && map.cols() == box.cols) return map;
  return crop(map, box.row, box.col, box.rows, box.cols);
}

// Radians. told: degrees for all pixels, or the name of a map; nothing where nothing is told
Grid<float> sigma_of_normals(const std::string& told, const Mask& mask) {
  constexpr double degree = std::numbers::pi / 180.0;
  if (told.empty()) return {};
  double sigma_deg = 0.0;
  const char* const end = told.data() + told.size();
  if (const auto read = std::from_chars(told.data(), end, sigma_deg);
      read.ec == std::errc() && read.ptr == end) {
    if (!(sigma_deg > 0.0 && sigma_deg <= 90.0)) {
      throw Error("--normal-sigma " + told + ": must lie above 0 and up to 90 degrees");
    }
    return {mask.rows(), mask.cols(), float(sigma_deg * degree), mask.memory()};
  }
  Grid<float> sigma = read_plane(told, mask);
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    if (mask[i] && !(sigma[i] >= 0.0f && std::isfinite(sigma[i]))) {
      throw Error(told + ": holds a sigma that is negative or no number inside the mask; give " +
                  "radians, as in normal_sigma.exr");
    }
  }
  return sigma;
}

Input read_input(const IntegrateArguments& arguments, DiskMemory& disk) {
  const auto memory = [&](const PictureShape& shape) -> std::pmr::memory_resource* {
    const bool large = std::size_t(shape.rows) * std::size_t(shape.cols) > most_in_ram;
    const bool on_disk = arguments.memory == "disk" || (arguments.memory == "automatic" && large);
    return on_disk ? &disk : nullptr;
  };
  NormalFile file = read_normals(arguments.normals, arguments.y_down, memory);
  Input input;
  input.share_away = file.share_away;
  input.share_off_length = file.share_off_length;
  if (arguments.mask) {
    Mask asked(file.mask.rows(), file.mask.cols(), 1, file.mask.memory());
    const Grid<float> picture = read_plane(*arguments.mask, file.mask);
    keep(asked, picture, 0.5f);
    require_bright_pixel(*arguments.mask, picture, asked);
    for (std::size_t i = 0; i < asked.size(); ++i) file.mask[i] = file.mask[i] && asked[i];
    const auto pixels = double(pixels_in(asked));
    if (pixels > 0.0) input.share_without_normal = 1.0 - double(pixels_in(file.mask)) / pixels;
  }
  Grid<float> weight;
  if (arguments.weights) {
    weight = read_plane(*arguments.weights, file.mask);
    const auto before = double(pixels_in(file.mask));
    keep(file.mask, weight, 0.0f);
    if (before > 0.0) input.share_without_weight = 1.0 - double(pixels_in(file.mask)) / before;
    for (float& w : weight) w = std::isfinite(w) && w > 0.0f ? w : 1.0f;
  }
  Grid<float> sigma = sigma_of_normals(arguments.normal_sigma, file.mask);
  if (pixels_in(file.mask) == 0) {
    throw Error(arguments.normals.string() +
                ": no pixel is left that has a normal and is in the mask; check the mask");
  }
  const PixelBox box = input.box = bounding_box(file.mask);
  input.frame = {.rows = file.mask.rows(), .cols = file.mask.cols()};
  if (arguments.pitch_mm) {
    input.frame.pitch = *arguments.pitch_mm;
    input.frame.unit = Unit::mm;
  }
  Surface& surface = input.surface;
  surface.extent = input.frame;
  surface.extent.rows = box.rows;
  surface.extent.cols = box.cols;
  surface.mask = cut(std::move(file.mask), box);
  surface.normals = cut(std::move(file.normals), box);
  surface.offset_px = {box.col, box.row};
  surface.normal_sigma = cut(std::move(sigma), box);
  input.options.weight = cut(std::move(weight), box);
  if (arguments.intrinsics) {
    const Eigen::Matrix3d k = read_intrinsics(*arguments.intrinsics);
    input.options.pin_hole =
        PinHole{{k(0, 0), k(1, 1)},
                {k(0, 2) + 0.5 - surface.offset_px.x(), k(1, 2) + 0.5 - surface.offset_px.y()}};
  }
  return input;
}

// D - z: along the optical axis, in units of the height.
void write_depth(const std::filesystem::path& path, const Surface& surface,
                 const PinHole& pin_hole) {
  const double distance = pin_hole.focal_px.x() * surface.extent.pitch;
  write_exr_rows(
      path, {.rows = surface.extent.rows, .cols = surface.extent.cols}, [&](int row, float* depth) {
        for (int col = 0; col < surface.extent.cols; ++col) {
          depth[col] =
              surface.mask(row, col) ? float(distance - surface.height(row, col)) : std::nanf("");
        }
      });
}

std::vector<std::string> remarks_on(const Input& input, bool y_down) {
  const Surface& surface = input.surface;
  std::vector<std::string> remarks;
  const auto percent = [](double share) { return fmt::format("{:.2g} %", 100.0 * share); };
  if (input.share_without_normal > 0.0) {
    remarks.push_back(percent(input.share_without_normal) +
                      " of the mask holds no normal and is left out");
  }
  if (input.share_without_weight > 0.0) {
    remarks.push_back(percent(input.share_without_weight) +
                      " of the pixels have a weight that is not above 0, and are left out");
  }
  constexpr double few = 0.01;
  if (input.share_away > few) {
    remarks.push_back(percent(input.share_away) +
                      " of the normals look away from the camera and are left out; x, y and z must "
                      "be its red, green and blue, and z point to the camera");
  }
  if (input.share_off_length > 0.5) {
    remarks.push_back(percent(input.share_off_length) +
                      " of the normals are no unit vectors: is this a normal map, stored as it is, "
                      "not for the eye?");
  }
  if (const auto& pin_hole = input.options.pin_hole) {
    constexpr double wide_deg = 60.0;
    const double off_axis_deg = farthest_off_axis_deg(*pin_hole, surface.mask);
    const double hidden = share_hidden(surface.normals, surface.mask, *pin_hole);
    if (off_axis_deg > wide_deg || hidden > few) {
      remarks.push_back(fmt::format(
          "the camera sees the surface up to {:.0f} degrees off its axis, and {} of the normals "
          "look away from it: focal length and centre must be in pixels of the normal map",
          off_axis_deg, percent(hidden)));
    }
  }
  constexpr double clearly = 4.0;
  if (const double gain = gain_of_turned_y(surface.normals, surface.mask); gain > clearly) {
    remarks.push_back(fmt::format(
        "the slopes would agree with a height {:.0f} times better if their y pointed the other "
        "way: {}",
        std::sqrt(gain), y_down ? "leave out --y-down" : "give --y-down"));
  }
  if (const auto remark = remark_on_regions(surface.mask)) remarks.push_back(*remark);
  return remarks;
}

std::string notes_of(const Input& input, const Integrated& found,
                     const std::vector<std::string>& remarks) {
  Json notes = {{"integration", found.may_jump ? "edge-aware" : "least squares"},
                {"reason", found.reason},
                {"projection", input.options.pin_hole ? "pin-hole" : "orthographic"},
                {"weighted", !input.options.weight.empty()},
                {"version", version()}};
  if (!remarks.empty()) notes["remarks"] = remarks;
  return notes.dump(1);
}

}  // namespace

void integrate_command(const IntegrateArguments& arguments, const Terminal& terminal) {
  Output output(arguments.out);
  DiskMemory disk(output.folder());  // outlives all maps
  terminal.step("reading the normal map");
  Input input = read_input(arguments, disk);
  Surface& surface = input.surface;
  std::optional<PriorHeights> prior;
  if (arguments.prior.file) {
    prior = read_prior(arguments.prior, input.frame, input.box, surface.mask.memory());
  }
  terminal.step("integrating");
  input.options.done = [&](int cycles, double error) {
    terminal.step(fmt::format("integrating: cycle {}, about {:.1g} px to go", cycles, error));
  };
  input.options.round_done = [&](int rounds) {
    terminal.step(fmt::format("looking for jumps: round {}", rounds));
  };
  Integrated found = integrate_with_jumps(surface.normals, surface.mask, surface.extent.pitch,
                                          jumps_named(arguments.jumps), input.options);
  surface.height = std::move(found.height);
  if (input.options.pin_hole) {
    write_depth(output.file("depth.exr"), surface, *input.options.pin_hole);
  }
  if (prior) {
    level(surface.height, surface.mask, *prior);
    surface.levelling_cutoff = prior->cutoff_px * surface.extent.pitch;
  } else {
    level(surface.height, surface.mask, levelling_named(arguments.levelling));
  }
  if (!surface.normal_sigma.empty()) {
    terminal.step("drawing heights for their sigma");
    surface.height_sigma =
        height_sigma(surface.normals, surface.normal_sigma, surface.mask, surface.extent.pitch,
                     levelling_named(arguments.levelling), prior ? &*prior : nullptr,
                     input.options.weight.empty() ? nullptr : &input.options.weight);
  }
  surface.levelling = prior ? std::string(prior_levelling) : arguments.levelling;

  terminal.step("writing the surface");
  const auto remarks = remarks_on(input, arguments.y_down);
  const std::string notes = notes_of(input, found, remarks);
  write_surface(output, "", surface, notes);
  put_previews(output, "", surface);
  output.commit();

  terminal.say(fmt::format("{} pixels, {} of them in the mask: {}", size_text(surface.extent),
                           pixels_in(surface.mask),
                           found.may_jump ? "a height that may jump" : "least-squares height"));
  terminal.say("because " + found.reason);
  if (prior) terminal.say(told_of_prior(arguments.prior, surface));
  for (const auto& remark : remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  terminal.result(notes);
}

}  // namespace hada
