#include "studio/material_api.h"

#include "app/material_file.h"
#include "app/material_tables.h"
#include "core/error.h"
#include "io/image_file.h"
#include "io/json.h"
#include "studio/folder.h"
#include "studio/scratch.h"
#include "studio/surface_bytes.h"
#include "synth/painted.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

// What is to be made: a material and how much of it.
struct Wanted {
  MaterialFile file;
  Extent extent;
  Seed seed = 1;
};

Wanted wanted_from(const Json& json, JsonObject& object) {
  Wanted wanted;
  object.object("file");  // an object, or an Error
  wanted.file = material_of(json["file"].dump(), "the material");
  const int size = object.integer("size_px");
  if (size < 16 || size > 2048) object.fail("size_px", "must lie between 16 and 2048");
  wanted.extent = {size, size, object.number("pitch"), wanted.file.unit};
  if (!(wanted.extent.pitch > 0.0)) object.fail("pitch", "must be greater than 0");
  const int seed = object.integer("seed");
  if (seed < 0) object.fail("seed", "must not be negative");
  wanted.seed = Seed(seed);
  return wanted;
}

HttpResponse map_of(const Surface& surface, const std::string& map) {
  const Scratch scratch;
  const auto path = scratch.path() / "map.exr";
  if (map == "height" && surface.has_height()) {
    write_exr(path, Image(surface.height));
  } else if (map == "albedo" && !surface.albedo.empty()) {
    write_exr(path, surface.albedo);
  } else if (map == "normal" && !surface.normals.empty()) {
    Image image(surface.extent.rows, surface.extent.cols, 3);
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      for (int c = 0; c < 3; ++c) image.planes[std::size_t(c)][i] = surface.normals[i][c];
    }
    write_exr(path, image);
  } else {
    throw Error(
        "this material has no map \"" + map +
        "\"; there are height, normal and albedo, of what was fitted to a picture albedo alone");
  }
  return download(map + ".exr", text_of_file(path));
}

}  // namespace

Surface MaterialApi::made(const Material& material, const Extent& extent, Seed seed) {
  const auto* steel = std::get_if<Forged<>>(&material);
  if (!steel) return synthesize(material, extent, seed);
  // Forging takes half a second; etching what is forged already keeps up with a slider.
  const Forging wanted{steel->sequence, steel->kernel, extent.rows, extent.cols, seed};
  if (wanted != forging_) {
    forged_ = forged_part(*steel, {extent.rows, extent.cols}, seed);
    forging_ = wanted;
  }
  return surface_of(*steel, forged_, extent);
}

HttpResponse MaterialApi::answer(const std::string& verb, const HttpRequest& request) {
  if (request.method == "GET" && verb == "tables") return {.body = material_tables_text()};
  if (request.method == "POST" && verb == "open") {
    const Json json = parsed_json(request.body, "the request");
    JsonObject object(json, "the request");
    const std::string name = object.text("name");
    object.finish();
    const std::string text = text_within(folder_, name);
    material_of(text, name);
    return {.body = text};
  }
  if (request.method == "POST" && verb == "file") {
    const Json json = parsed_json(request.body, "the request");
    JsonObject object(json, "the request");
    object.object("file");
    object.finish();
    const MaterialFile file = material_of(json["file"].dump(), "the material");
    return {.body = Json{{"text", material_text(file)}}.dump()};
  }
  if (request.method == "POST" && (verb == "preview" || verb == "map")) {
    const Json json = parsed_json(request.body, "the request");
    JsonObject object(json, "the request");
    const Wanted wanted = wanted_from(json, object);
    const std::string map = verb == "map" ? object.text("map") : "";
    object.finish();
    const std::lock_guard lock(busy_);
    const Surface surface =
        painted(made(wanted.file.material, wanted.extent, wanted.seed), wanted.file.mean_albedo);
    if (verb == "map") return map_of(surface, map);
    return {.type = "application/octet-stream", .body = surface_bytes(surface)};
  }
  throw Error("material/" + verb + ": there is no such request");
}

}  // namespace hada
