#include "app/block_file.h"

#include <set>

#include "core/error.h"
#include "io/json.h"
#include "io/surface_file.h"

namespace hada {
namespace {

StemVector vector_in(JsonObject& object, const std::string& key, const StemVector& otherwise) {
  if (!object.has(key)) return otherwise;
  const auto numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

Cut cut_in(JsonObject& object) {
  const Cut usual;  // the end grain
  return cut_along(vector_in(object, "origin_mm", usual.origin),
                   vector_in(object, "right", usual.right), vector_in(object, "up", usual.up));
}

std::optional<double> pitch_in(JsonObject& object) {
  if (!object.has("pitch_mm")) return {};
  const double pitch = object.number("pitch_mm");
  if (!(pitch > 0.0)) object.fail("pitch_mm", "must be greater than 0");
  return pitch;
}

PlacedFace face_in(JsonObject object, const std::filesystem::path& folder) {
  PlacedFace face;
  const std::filesystem::path picture = object.text("picture");
  face.name = object.text("name", picture.stem().string());
  face.cut = cut_in(object);
  face.surface = read_surface(folder / picture, pitch_in(object));
  object.finish();
  return face;
}

NamedCut asked_in(JsonObject object, Unit unit) {
  constexpr int most_px = 16384;
  NamedCut asked;
  asked.name = object.text("name");
  asked.cut = cut_in(object);
  const auto size = object.numbers("size_px", 2);
  for (const double side : size) {
    if (!(side >= 16.0 && side <= most_px))
      object.fail("size_px", "must be a width and a height of 16 to 16384 pixels");
  }
  asked.extent = {int(size[1]), int(size[0]), pitch_in(object).value_or(1.0), unit};
  object.finish();
  return asked;
}

}  // namespace

BlockFile read_block(const std::filesystem::path& path) {
  const Json json = read_json(path, "block/1");
  JsonObject object(json, path.string());
  BlockFile block;
  std::set<std::string> names;
  const auto check_name = [&](const std::string& name, const std::string& key) {
    const bool plain = !name.empty() && name.find_first_of("/\\") == std::string::npos;
    if (!plain || name[0] == '.' || !names.insert(name).second)
      object.fail(key, "needs names that are file names, each once; \"" + name + "\" is not");
  };
  for (const Json& face : object.list("faces")) {
    const std::string index = "[" + std::to_string(block.faces.size()) + "]";
    block.faces.push_back(
        face_in(JsonObject(face, object.where() + ".faces" + index), path.parent_path()));
    check_name(block.faces.back().name, "faces");
    if (block.faces.back().surface.extent.unit != block.faces.front().surface.extent.unit)
      object.fail("faces", "must all have a pitch_mm, or none");
  }
  if (block.faces.empty()) object.fail("faces", "must name one picture at least");
  if (object.has("cuts")) {
    for (const Json& cut : object.list("cuts")) {
      const std::string index = "[" + std::to_string(block.cuts.size()) + "]";
      block.cuts.push_back(asked_in(JsonObject(cut, object.where() + ".cuts" + index),
                                    block.faces.front().surface.extent.unit));
      check_name(block.cuts.back().name, "cuts");
    }
  }
  object.finish();
  return block;
}

}  // namespace hada
