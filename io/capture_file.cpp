#include "io/capture_file.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "io/capture_folder.h"
#include "io/json_light.h"

namespace hada {
namespace {

namespace fs = std::filesystem;
using OptionalPath = std::optional<fs::path>;

std::string entry(const std::string& file, const std::string& list, std::size_t i) {
  return file + ": " + list + "[" + std::to_string(i) + "]";
}

std::optional<double> positive(JsonObject& object, const std::string& key) {
  if (!object.has(key)) return std::nullopt;
  const double value = object.number(key);
  if (value <= 0.0) object.fail(key, "must be larger than 0");
  return value;
}

std::optional<BoxPx> box(JsonObject& object, const std::string& key) {
  if (!object.has(key)) return std::nullopt;
  const auto edge = object.numbers(key, 4);
  if (edge[0] >= edge[2] || edge[1] >= edge[3]) {
    object.fail(key, "must be [left, top, right, bottom] in px, with left < right, top < bottom");
  }
  return BoxPx{edge[0], edge[1], edge[2], edge[3]};
}

fs::path existing(const JsonObject& object, const std::string& key, const fs::path& folder,
                  const std::string& name) {
  std::error_code ignored;
  if (!name.empty() && fs::is_regular_file(folder / name, ignored)) return folder / name;
  object.fail(key, "names " + Json(name).dump() + ", which is not a file in " + folder.string());
}

CaptureFile::Picture picture_from(const Json& json, const std::string& where,
                                  const fs::path& folder) {
  CaptureFile::Picture picture;
  const Json as_object = json.is_string() ? Json::object({{"file", json}}) : json;
  JsonObject object(as_object, where);
  picture.name = object.text("file");
  picture.file = existing(object, "file", folder, picture.name);
  if (object.has("light")) picture.direction = direction_from(object, "light");
  if (object.has("strength")) picture.strength = strength_from(object, "strength");
  object.finish();
  return picture;
}

CaptureFile::SphereHint sphere_from(JsonObject object) {
  CaptureFile::SphereHint sphere;
  const std::string kind = object.text("kind", "auto");
  if (kind == "matte")
    sphere.kind = SphereKind::matte;
  else if (kind == "chrome")
    sphere.kind = SphereKind::chrome;
  else if (kind != "auto")
    object.fail("kind", "must be auto, matte or chrome");
  sphere.box = box(object, "box_px");
  sphere.diameter_mm = positive(object, "diameter_mm");
  object.finish();
  return sphere;
}

CaptureFile::CameraHint camera_from(JsonObject object) {
  CaptureFile::CameraHint camera;
  const std::string model = object.text("model", "orthographic");
  if (model != "orthographic" && model != "perspective") {
    object.fail("model", "must be orthographic or perspective");
  }
  camera.perspective = model == "perspective";
  camera.focal_px = positive(object, "focal_px");
  camera.distance_mm = positive(object, "distance_mm");
  object.finish();
  return camera;
}

std::array<double, 3> vignetting_from(JsonObject& object) {
  const auto k = object.numbers("vignetting", 3);
  constexpr double least_light = 0.05;
  for (int percent = 0; percent <= 100; ++percent) {
    const double square = 1e-4 * percent * percent;
    const double left = 1.0 + square * (k[0] + square * (k[1] + square * k[2]));
    if (!(left >= least_light && left <= 1.0 / least_light)) {
      object.fail("vignetting", "must leave between 0.05 and 20 times the light everywhere");
    }
  }
  return {k[0], k[1], k[2]};
}

// What the manifest says; it may leave the pictures to the folder.
CaptureFile read_manifest(const fs::path& manifest) {
  const Json json = read_json(manifest, "capture/1");
  const std::string name = manifest.string();
  CaptureFile capture;
  capture.folder = manifest.parent_path();
  JsonObject object(json, name);
  if (object.has("images")) {
    const Json& images = object.list("images");
    if (images.empty()) object.fail("images", "is empty; name the pictures or leave the key out");
    std::set<std::string> seen;
    for (std::size_t i = 0; i < images.size(); ++i) {
      capture.pictures.push_back(picture_from(images[i], entry(name, "images", i), capture.folder));
      if (!seen.insert(capture.pictures.back().name).second) {
        object.fail("images", "names " + capture.pictures.back().name + " twice");
      }
    }
  }
  capture.encoding = object.text("encoding", "auto");
  if (!std::set<std::string>{"auto", "linear", "srgb"}.contains(capture.encoding)) {
    object.fail("encoding", "must be auto, linear or srgb");
  }
  capture.pitch_mm = positive(object, "pitch_mm");
  if (object.has("spheres")) {
    const Json& spheres = object.list("spheres");
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      capture.spheres.push_back(sphere_from(JsonObject(spheres[i], entry(name, "spheres", i))));
    }
  }
  capture.sample_box = box(object, "sample_box_px");
  const auto file = [&](const std::string& key) -> OptionalPath {
    if (!object.has(key)) return std::nullopt;
    return existing(object, key, capture.folder, object.text(key));
  };
  capture.mask = file("mask");
  capture.ambient = file("ambient");
  capture.flat = file("flat");
  capture.dark = file("dark");
  if (object.has("camera")) capture.camera = camera_from(object.object("camera"));
  capture.lamps = object.text("lamps", "auto");
  if (!std::set<std::string>{"auto", "distant", "near"}.contains(capture.lamps)) {
    object.fail("lamps", "must be auto, distant or near");
  }
  if (object.has("vignetting")) capture.vignetting = vignetting_from(object);
  object.finish();
  return capture;
}

// Fills in from the names in the folder what the manifest did not say.
void complete_from_folder(CaptureFile& capture) {
  CaptureFolder sorted = sorted_folder(capture.folder);
  const std::pair<const char*, OptionalPath*> roles[] = {{"mask", &capture.mask},
                                                         {"ambient", &capture.ambient},
                                                         {"flat", &capture.flat},
                                                         {"dark", &capture.dark}};
  std::set<std::string> spoken_for;
  for (const auto& [role, path] : roles) {
    if (*path) spoken_for.insert((*path)->lexically_relative(capture.folder).string());
  }
  for (const auto& [role, path] : roles) {
    const auto found = sorted.auxiliary.find(role);
    if (found == sorted.auxiliary.end() || spoken_for.contains(found->second)) continue;
    if (*path)
      sorted.left_out.push_back(found->second + " (another " + role + ")");
    else
      *path = capture.folder / found->second;
  }
  for (const auto& name : sorted.pictures) {
    if (spoken_for.contains(name)) continue;
    capture.pictures.push_back({capture.folder / name, name, std::nullopt, std::nullopt});
  }
  capture.left_out = std::move(sorted.left_out);
}

std::string relative_name(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return inside ? relative.generic_string() : file.generic_string();
}

Json json_of_picture(const CaptureFile::Picture& picture, const fs::path& folder) {
  const std::string name = relative_name(picture.file, folder);
  if (!picture.direction && !picture.strength) return name;
  Json json = {{"file", name}};
  if (picture.direction) json["light"] = json_of_vector(*picture.direction);
  if (picture.strength) json["strength"] = json_of_strength(*picture.strength);
  return json;
}

Json json_of_sphere(const CaptureFile::SphereHint& sphere) {
  Json json = {{"kind", sphere.kind ? std::string(name_of(*sphere.kind)) : "auto"}};
  if (sphere.box) json["box_px"] = *sphere.box;
  if (sphere.diameter_mm) json["diameter_mm"] = *sphere.diameter_mm;
  return json;
}

Json json_of_camera(const CaptureFile::CameraHint& camera) {
  Json json = {{"model", camera.perspective ? "perspective" : "orthographic"}};
  if (camera.focal_px) json["focal_px"] = *camera.focal_px;
  if (camera.distance_mm) json["distance_mm"] = *camera.distance_mm;
  return json;
}

}  // namespace

CaptureFile read_capture_file(const fs::path& folder) {
  std::error_code ignored;
  CaptureFile capture;
  capture.folder = folder;
  if (fs::exists(folder / "capture.json", ignored))
    capture = read_manifest(folder / "capture.json");
  if (capture.pictures.empty()) complete_from_folder(capture);
  if (capture.pictures.empty()) {
    throw Error(folder.string() + ": holds no photographs; put the pictures of the sample there");
  }
  return capture;
}

std::string capture_text(const CaptureFile& capture) {
  Json json = {{"hada", "capture/1"}};
  for (const auto& picture : capture.pictures) {
    json["images"].push_back(json_of_picture(picture, capture.folder));
  }
  json["encoding"] = capture.encoding;
  if (capture.pitch_mm) json["pitch_mm"] = *capture.pitch_mm;
  for (const auto& sphere : capture.spheres) json["spheres"].push_back(json_of_sphere(sphere));
  if (capture.sample_box) json["sample_box_px"] = *capture.sample_box;
  const auto add_file = [&](const char* key, const OptionalPath& file) {
    if (file) json[key] = relative_name(*file, capture.folder);
  };
  add_file("mask", capture.mask);
  add_file("ambient", capture.ambient);
  add_file("flat", capture.flat);
  add_file("dark", capture.dark);
  if (capture.camera) json["camera"] = json_of_camera(*capture.camera);
  if (capture.lamps != "auto") json["lamps"] = capture.lamps;
  if (capture.vignetting != std::array<double, 3>{}) json["vignetting"] = capture.vignetting;
  return json.dump(2) + "\n";
}

}  // namespace hada
