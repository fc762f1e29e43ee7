#include "studio/surface_api.h"

#include <algorithm>
#include <system_error>

#include "app/draw/maps.h"
#include "app/material_file.h"
#include "core/error.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "studio/folder.h"
#include "studio/surface_bytes.h"
#include "synth/painted.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 4;  // folders below the one that is opened
constexpr std::size_t most_entries = 500;
constexpr int most_px = 2048;  // of a side, as it is sent

struct Entry {
  std::string name;
  bool surface;  // a folder with a surface, else a picture
};

// Surfaces and pictures beneath a folder, without what is hidden or lies behind links.
void gather(const fs::path& root, const fs::path& folder, int depth, std::vector<Entry>& entries) {
  std::error_code problem;
  std::vector<fs::path> inside;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || name == "node_modules" || entry.is_symlink(problem)) continue;
    inside.push_back(entry.path());
  }
  std::sort(inside.begin(), inside.end());
  for (const fs::path& path : inside) {
    if (entries.size() >= most_entries) return;
    const std::string name = fs::relative(path, root, problem).generic_string();
    if (fs::is_directory(path, problem)) {
      const bool surface = fs::is_regular_file(path / "surface.json", problem);
      if (surface) entries.push_back({name, true});
      if (!surface && depth < deepest) gather(root, path, depth + 1, entries);
    } else if (has_image_name(path) && fs::is_regular_file(path, problem)) {
      entries.push_back({name, false});
    }
  }
}

Surface small(Surface surface) {
  if (std::max(surface.extent.rows, surface.extent.cols) <= most_px) return surface;
  Surface less =
      surface.has_height() || !surface.normals.empty() ? shrunk(surface, most_px) : Surface{};
  less.albedo = shrunk(surface.albedo, most_px);
  if (less.mask.empty()) {
    less.extent = surface.extent;
    less.extent.pitch *= double(surface.extent.cols) / less.albedo.cols();
    less.extent.rows = less.albedo.rows();
    less.extent.cols = less.albedo.cols();
    less.mask = full_mask(less.extent);
  }
  if (less.albedo.rows() != less.extent.rows || less.albedo.cols() != less.extent.cols) {
    less.albedo = {};
  }
  const auto add_sigma = [&](const Grid<float>& of, Grid<float>& to) {
    if (of.empty()) return;
    const Image mean = shrunk(Image(of), most_px);
    if (mean.rows() == less.extent.rows && mean.cols() == less.extent.cols) to = mean.planes[0];
  };
  add_sigma(surface.normal_sigma, less.normal_sigma);
  add_sigma(surface.height_sigma, less.height_sigma);
  return less;
}

}  // namespace

HttpResponse SurfaceApi::answer(const std::string& verb, const HttpRequest& request) {
  if (request.method == "GET" && verb == "list") {
    std::vector<Entry> entries;
    gather(folder_, folder_, 0, entries);
    Json list = Json::array();
    for (const Entry& entry : entries) {
      list.push_back({{"name", entry.name}, {"kind", entry.surface ? "surface" : "picture"}});
    }
    return {.body = Json{{"entries", list}, {"all", entries.size() < most_entries}}.dump()};
  }
  if (request.method == "POST" && (verb == "maps" || verb == "like")) {
    const Json json = parsed_json(request.body, "the request");
    JsonObject object(json, "the request");
    const std::string name = object.text("name");
    const int seed = verb == "like" ? object.integer("seed") : 0;
    if (seed < 0) object.fail("seed", "must not be negative");
    if (verb == "like") object.object("file");
    object.finish();
    const fs::path place = place_within(folder_, name);
    const std::lock_guard lock(busy_);
    try {
      Surface surface = small(read_surface(place));
      if (verb == "like") {
        const MaterialFile file = material_of(json["file"].dump(), "the material");
        surface = painted(synthesize(file.material, surface.extent, Seed(seed)), file.mean_albedo);
      }
      return {.type = "application/octet-stream", .body = surface_bytes(surface)};
    } catch (const Error& error) {
      // Errors of files name them in full; the page knows them by their place in the folder.
      throw Error(without_folder(folder_, error.what()));
    }
  }
  throw Error("surface/" + verb + ": there is no such request");
}

}  // namespace hada
