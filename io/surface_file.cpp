#include "io/surface_file.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <system_error>

#include "io/image_file.h"
#include "io/json.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<const char*, 6> map_names = {
    "mask.png", "height.exr", "normal.exr", "albedo.exr", "normal_sigma.exr", "height_sigma.exr"};
constexpr double length_tolerance = 0.01;  // ten times the rounding of a half float

PictureShape shape_of(const Mask& mask, int channels) {
  return {.rows = mask.rows(), .cols = mask.cols(), .channels = channels};
}

// The values of the pixels inside the mask, `value(row, col, channel)`.
template <class Value>
RowSource inside(const Mask& mask, int channels, const Value& value) {
  return [&mask, channels, value](int row, float* pixels) {
    for (int col = 0; col < mask.cols(); ++col) {
      for (int c = 0; c < channels; ++c) {
        *pixels++ = mask(row, col) ? value(row, col, c) : nowhere;
      }
    }
  };
}

void check_size(const fs::path& path, const Extent& extent) {
  if (extent.rows >= 2 && extent.cols >= 2) return;
  throw Error(path.string() + ": is " + std::to_string(extent.cols) + " x " +
              std::to_string(extent.rows) +
              " pixels, too small for a surface; give at least 2 x 2");
}

void check_mask(const fs::path& path, const Mask& mask) {
  for (const auto inside : mask) {
    if (inside) return;
  }
  throw Error(path.string() + ": no pixel has a meaning; check its mask");
}

// One map of a surface folder: of the right size, finite inside the mask, 0 outside.
Image map_of(const fs::path& path, const Surface& surface, int channels) {
  Image image = read_image(path).image;
  if (image.rows() != surface.extent.rows || image.cols() != surface.extent.cols) {
    throw Error(path.string() + ": is not of the size that surface.json says; make it again");
  }
  if (channels != 0 && image.channels() != channels) {
    throw Error(path.string() + ": has " + std::to_string(image.channels()) + " channels, not " +
                std::to_string(channels) + "; make it again");
  }
  for (auto& plane : image.planes) {
    for (std::size_t i = 0; i < plane.size(); ++i) {
      if (!surface.mask[i]) {
        plane[i] = 0.0f;
      } else if (!std::isfinite(plane[i])) {
        throw Error(path.string() + ": holds a value inside the mask that is not a number; " +
                    "correct the map or the mask");
      }
    }
  }
  return image;
}

NormalMap normals_from(const fs::path& path, const Surface& surface) {
  const Image image = map_of(path, surface, 3);
  NormalMap normals(image.rows(), image.cols(), Eigen::Vector3f::UnitZ());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!surface.mask[i]) continue;
    const Eigen::Vector3f n(image.planes[0][i], image.planes[1][i], image.planes[2][i]);
    if (n.z() <= 0.0f || std::abs(n.norm() - 1.0) > length_tolerance) {
      throw Error(path.string() + ": holds a vector that is no normal (unit length, z > 0); " +
                  "make the map again");
    }
    normals[i] = n;
  }
  return normals;
}

void scale(Grid<float>& heights, double factor) {
  for (float& height : heights) height = float(height * factor);
}

// The slopes are what was seen, so another pitch makes the whole surface larger, heights too.
void change_pitch(Surface& surface, double pitch_mm) {
  scale(surface.height, pitch_mm / surface.extent.pitch);
  scale(surface.height_sigma, pitch_mm / surface.extent.pitch);
  surface.levelling_cutoff *= pitch_mm / surface.extent.pitch;
  surface.extent.pitch = pitch_mm;
  surface.extent.unit = Unit::mm;
}

void level_to_zero_mean(Grid<float>& height, const Mask& mask) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (!mask[i]) continue;
    sum += height[i];
    ++count;
  }
  for (std::size_t i = 0; i < height.size(); ++i) {
    height[i] = mask[i] ? float(height[i] - sum / double(count)) : 0.0f;
  }
}

// The maps that surface.json names: others of these names may be left from an earlier surface. A
// description without the list means every map that is there.
std::optional<std::set<std::string>> listed_maps(JsonObject& object) {
  if (!object.has("maps")) return std::nullopt;
  std::set<std::string> maps;
  for (const Json& name : object.list("maps")) {
    if (!name.is_string()) object.fail("maps", "must be a list of file names");
    maps.insert(name.get<std::string>());
  }
  return maps;
}

// Fills in everything but the maps, and returns which of them to read.
std::set<std::string> read_description(const fs::path& path, Surface& surface) {
  const Json json = read_json(path, "surface/1");
  JsonObject object(json, path.string());
  surface.extent.rows = object.integer("rows");
  surface.extent.cols = object.integer("cols");
  surface.extent.pitch = object.number("pitch");
  if (surface.extent.pitch <= 0.0) object.fail("pitch", "must be larger than 0");
  const std::string unit = object.text("unit");
  if (unit != "mm" && unit != "px") object.fail("unit", "must be mm or px");
  surface.extent.unit = unit == "mm" ? Unit::mm : Unit::px;
  surface.levelling = object.text("levelling");
  if (object.has("levelling_cutoff")) {
    surface.levelling_cutoff = object.number("levelling_cutoff");
    if (!(surface.levelling_cutoff > 0.0)) object.fail("levelling_cutoff", "must be larger than 0");
  }
  const auto offset = object.numbers("offset_px", 2);
  surface.offset_px = {int(offset[0]), int(offset[1])};
  object.has("notes");
  const auto listed = listed_maps(object);
  object.finish();
  check_size(path, surface.extent);
  std::set<std::string> maps;
  for (const char* name : map_names) {
    std::error_code ignored;
    if (listed ? listed->contains(name) : fs::exists(path.parent_path() / name, ignored)) {
      maps.insert(name);
    }
  }
  return maps;
}

Surface read_folder(const fs::path& folder, SurfaceMaps wanted) {
  Surface surface;
  auto maps = read_description(folder / "surface.json", surface);
  if (wanted == SurfaceMaps::height_alone && maps.contains("height.exr")) {
    std::erase_if(maps,
                  [](const auto& name) { return name != "mask.png" && name != "height.exr"; });
  }
  surface.mask = full_mask(surface.extent);
  const auto has = [&](const char* name) { return maps.contains(name); };
  if (has("mask.png")) {
    const Grid<float> mask = luminance(map_of(folder / "mask.png", surface, 0));
    for (std::size_t i = 0; i < mask.size(); ++i) surface.mask[i] = mask[i] > 0.5f;
    check_mask(folder / "mask.png", surface.mask);
  }
  const auto plane = [&](const char* name) {
    return has(name) ? map_of(folder / name, surface, 1).planes.front() : Grid<float>();
  };
  surface.height = plane("height.exr");
  surface.normal_sigma = plane("normal_sigma.exr");
  surface.height_sigma = plane("height_sigma.exr");
  if (has("albedo.exr")) surface.albedo = map_of(folder / "albedo.exr", surface, 0);
  if (has("normal.exr")) surface.normals = normals_from(folder / "normal.exr", surface);
  if (wanted == SurfaceMaps::all && surface.normals.empty() && surface.has_height()) {
    surface.normals = normals_of(surface.height, surface.mask, surface.extent.pitch);
  }
  if (!surface.has_height() && surface.normals.empty() && surface.albedo.empty()) {
    throw Error(folder.string() + ": has neither height.exr nor normal.exr nor albedo.exr; " +
                "make the surface again");
  }
  return surface;
}

Surface read_single(const fs::path& path, double pitch, Unit unit, SurfaceMaps wanted) {
  ImageFile file = read_image(path);
  Surface surface;
  surface.extent = {file.image.rows(), file.image.cols(), pitch, unit};
  check_size(path, surface.extent);
  surface.mask = full_mask(surface.extent);
  for (auto& plane : file.image.planes) {
    for (std::size_t i = 0; i < plane.size(); ++i) {
      if (std::isfinite(plane[i])) continue;
      surface.mask[i] = 0;
      plane[i] = 0.0f;
    }
  }
  check_mask(path, surface.mask);
  if (file.floating && file.image.channels() == 1) {
    surface.height = std::move(file.image.planes.front());
    level_to_zero_mean(surface.height, surface.mask);
    if (wanted == SurfaceMaps::all)
      surface.normals = normals_of(surface.height, surface.mask, pitch);
    return surface;
  }
  if (!file.floating && file.bits <= 8) {
    for (auto& plane : file.image.planes) {
      for (float& value : plane) value = linear_from_srgb(value);
    }
  }
  surface.albedo = std::move(file.image);
  return surface;
}

}  // namespace

void write_surface(Output& output, const std::string& folder, const Surface& surface,
                   const std::string& notes_json) {
  Json maps = Json::array({"mask.png"});
  const Mask& mask = surface.mask;
  write_integer_rows(output.file(folder + "mask.png"), shape_of(mask, 1), 8,
                     [&](int row, float* pixels) {
                       for (const auto pixel : mask.row(row)) *pixels++ = pixel ? 1.0f : 0.0f;
                     });
  const auto write_map = [&](const char* name, int channels, const auto& value) {
    write_exr_rows(output.file(folder + name), shape_of(mask, channels),
                   inside(mask, channels, value));
    maps.push_back(name);
  };
  const auto write_plane = [&](const char* name, const Grid<float>& plane) {
    if (plane.empty()) return;
    write_map(name, 1, [&plane](int row, int col, int) { return plane(row, col); });
  };
  write_plane("height.exr", surface.height);
  if (!surface.normals.empty()) {
    write_map("normal.exr", 3,
              [&](int row, int col, int c) { return surface.normals(row, col)[c]; });
  }
  if (!surface.albedo.empty()) {
    write_map("albedo.exr", surface.albedo.channels(), [&](int row, int col, int c) {
      return surface.albedo.planes[std::size_t(c)](row, col);
    });
  }
  write_plane("normal_sigma.exr", surface.normal_sigma);
  write_plane("height_sigma.exr", surface.height_sigma);

  const Extent& extent = surface.extent;
  Json json = {{"hada", "surface/1"},
               {"rows", extent.rows},
               {"cols", extent.cols},
               {"pitch", extent.pitch},
               {"unit", std::string(name_of(extent.unit))},
               {"levelling", surface.levelling},
               {"offset_px", Json::array({surface.offset_px.x(), surface.offset_px.y()})},
               {"maps", std::move(maps)}};
  if (surface.levelling_cutoff > 0.0) json["levelling_cutoff"] = surface.levelling_cutoff;
  if (!notes_json.empty()) json["notes"] = Json::parse(notes_json);
  const fs::path description = output.file(folder + "surface.json");
  std::ofstream stream(description, std::ios::binary);
  stream << json.dump(2) << "\n";
  stream.close();
  if (!stream) throw Error(description.string() + ": cannot be written; check the free space");
}

Surface read_surface(const fs::path& path, std::optional<double> pitch_mm, SurfaceMaps maps) {
  if (pitch_mm && !(*pitch_mm > 0.0 && std::isfinite(*pitch_mm))) {
    throw Error(path.string() + ": the pitch must be larger than 0 mm");
  }
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) {
    return read_single(path, pitch_mm.value_or(1.0), pitch_mm ? Unit::mm : Unit::px, maps);
  }
  if (!fs::exists(path / "surface.json", ignored)) {
    throw Error(path.string() + ": is a folder without surface.json; name a surface folder, " +
                "a height map or a picture");
  }
  Surface surface = read_folder(path, maps);
  if (pitch_mm) change_pitch(surface, *pitch_mm);
  return surface;
}

}  // namespace hada
