#include "io/lights_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/json_light.h"
#include "io/lp_file.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

LightsFile lights_from_lp(const std::filesystem::path& path) {
  LightsFile file;
  file.lights = read_lp(path);
  file.strengths_measured = false;
  return file;
}

std::string position_key(Unit unit) {
  return "position_" + std::string(name_of(unit));
}

std::string entry(const std::string& file, const std::string& list, std::size_t i) {
  return file + ": " + list + "[" + std::to_string(i) + "]";
}

// Where a near light stands, and in which unit; all lights of a file must agree on it.
void read_position(Light& light, std::optional<Unit>& unit, JsonObject& object) {
  for (const Unit said : {Unit::mm, Unit::px}) {
    const std::string key = position_key(said);
    if (!object.has(key)) continue;
    if (unit.value_or(said) != said) {
      object.fail(key, "mixes mm and px; give all positions in one unit");
    }
    unit = said;
    light.position = vector_from(object, key);
    if (!(light.position->norm() > 0.0)) object.fail(key, "is the origin; no lamp can stand there");
  }
}

Light light_from(JsonObject object, std::optional<Unit>& unit) {
  Light light;
  light.image = object.text("image");
  light.direction = direction_from(object, "direction");
  light.strength = strength_from(object, "strength");
  light.direction_sigma = object.number("direction_sigma_deg", 0.0) * degree;
  if (light.direction_sigma < 0.0) object.fail("direction_sigma_deg", "must not be negative");
  read_position(light, unit, object);
  object.finish();
  return light;
}

// One mode: for each light a vector of three finite numbers.
LightErrorMode mode_from(const Json& json, std::size_t lights, const JsonObject& file) {
  LightErrorMode mode;
  const auto is_finite = [](const Json& entry) {
    return entry.is_number() && std::isfinite(entry.get<double>());
  };
  const auto is_vector = [&](const Json& entry) {
    return entry.is_array() && entry.size() == 3 &&
           std::all_of(entry.begin(), entry.end(), is_finite);
  };
  if (!json.is_array() || json.size() != lights ||
      !std::all_of(json.begin(), json.end(), is_vector)) {
    file.fail("error_modes", "must be a list of modes, each with " + std::to_string(lights) +
                                 " entries of 3 finite numbers, one for each light");
  }
  for (const Json& entry : json) {
    mode.emplace_back(entry[0].get<double>(), entry[1].get<double>(), entry[2].get<double>());
  }
  return mode;
}

Json json_of_mode(const LightErrorMode& mode) {
  Json json = Json::array();
  for (const auto& vector : mode) json.push_back(json_of_vector(vector));
  return json;
}

Json json_of_light(const Light& light, Unit unit) {
  Json json = {{"image", light.image},
               {"direction", json_of_vector(light.direction)},
               {"strength", json_of_strength(light.strength)}};
  if (light.direction_sigma > 0.0) json["direction_sigma_deg"] = light.direction_sigma / degree;
  if (light.position) json[position_key(unit)] = json_of_vector(*light.position);
  return json;
}

Sphere sphere_from(JsonObject object) {
  Sphere sphere;
  const std::string kind = object.text("kind");
  if (kind != "matte" && kind != "chrome") object.fail("kind", "must be matte or chrome");
  sphere.kind = kind == "matte" ? SphereKind::matte : SphereKind::chrome;
  const auto center = object.numbers("center_px", 2);
  sphere.center_px = {center[0], center[1]};
  sphere.radius_px = object.number("radius_px");
  if (sphere.radius_px <= 0.0) object.fail("radius_px", "must be larger than 0");
  sphere.sigma_px = object.number("sigma_px", 0.0);
  if (object.has("diameter_mm")) sphere.diameter_mm = object.number("diameter_mm");
  object.finish();
  return sphere;
}

Json json_of_sphere(const Sphere& sphere) {
  Json json = {{"kind", std::string(name_of(sphere.kind))},
               {"center_px", Json::array({sphere.center_px.x(), sphere.center_px.y()})},
               {"radius_px", sphere.radius_px}};
  if (sphere.sigma_px > 0.0) json["sigma_px"] = sphere.sigma_px;
  if (sphere.diameter_mm) json["diameter_mm"] = *sphere.diameter_mm;
  return json;
}

std::vector<Eigen::Vector2d> places_from(const Json& entries, const JsonObject& object) {
  std::vector<Eigen::Vector2d> places;
  if (!entries.is_array()) object.fail("highlights_px", "must hold a list for each light");
  for (const Json& entry : entries) {
    const bool pair =
        entry.is_array() && entry.size() == 2 && entry[0].is_number() && entry[1].is_number();
    if (!pair) object.fail("highlights_px", "must hold places [u, v]");
    places.emplace_back(entry[0].get<double>(), entry[1].get<double>());
  }
  return places;
}

Json json_of_places(const std::vector<Eigen::Vector2d>& places) {
  Json json = Json::array();
  for (const auto& p : places) {
    if (p.allFinite()) json.push_back({p.x(), p.y()});  // else the sphere does not show it
  }
  return json;
}

}  // namespace

LightsFile read_lights(const std::filesystem::path& path) {
  if (is_lp(path)) return lights_from_lp(path);
  const Json json = read_json(path, "lights/1");
  const std::string name = path.string();
  JsonObject object(json, name);
  LightsFile file;
  const Json& lights = object.list("lights");
  if (lights.empty()) object.fail("lights", "is empty; give one entry for each picture");
  std::optional<Unit> unit;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    file.lights.push_back(light_from(JsonObject(lights[i], entry(name, "lights", i)), unit));
  }
  file.position_unit = unit.value_or(Unit::mm);
  if (object.has("error_modes")) {
    for (const Json& mode : object.list("error_modes")) {
      file.errors.push_back(mode_from(mode, file.lights.size(), object));
    }
  }
  if (object.has("spheres")) {
    const Json& spheres = object.list("spheres");
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      file.spheres.push_back(sphere_from(JsonObject(spheres[i], entry(name, "spheres", i))));
    }
  }
  if (object.has("highlights_px")) {
    for (const Json& entries : object.list("highlights_px")) {
      file.highlights_px.push_back(places_from(entries, object));
    }
    if (file.highlights_px.size() != file.lights.size()) {
      object.fail("highlights_px", "must hold a list for each light");
    }
  }
  file.strengths_measured = object.flag("strengths_measured", true);
  file.encoding = object.text("encoding", "");
  if (!file.encoding.empty() && file.encoding != "linear" && file.encoding != "srgb") {
    object.fail("encoding", "must be linear or srgb");
  }
  object.finish();
  return file;
}

std::string lights_text(const LightsFile& file) {
  Json json = {{"hada", "lights/1"}};
  if (!file.encoding.empty()) json["encoding"] = file.encoding;
  if (!file.strengths_measured) json["strengths_measured"] = false;
  json["lights"] = Json::array();
  for (const Light& light : file.lights) {
    json["lights"].push_back(json_of_light(light, file.position_unit));
  }
  if (!file.errors.empty()) {
    json["error_modes"] = Json::array();
    for (const auto& mode : file.errors) json["error_modes"].push_back(json_of_mode(mode));
  }
  json["spheres"] = Json::array();
  for (const Sphere& sphere : file.spheres) json["spheres"].push_back(json_of_sphere(sphere));
  for (const auto& places : file.highlights_px)
    json["highlights_px"].push_back(json_of_places(places));
  return json.dump(2) + "\n";
}

}  // namespace hada
