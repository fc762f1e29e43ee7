#include "app/recipe.h"

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "app/material_file.h"
#include "io/json.h"
#include "io/json_light.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double most_cells = 134217728.0;  // 2^27 of a fine lattice: half a GB for one map

double within(JsonObject& object, const std::string& key, double value, double low, double high) {
  if (value < low || value > high) {
    object.fail(key, "must lie between " + Json(low).dump() + " and " + Json(high).dump());
  }
  return value;
}

double number_within(JsonObject& object, const std::string& key, double otherwise, double low,
                     double high) {
  return within(object, key, object.number(key, otherwise), low, high);
}

double positive(JsonObject& object, const std::string& key) {
  const double value = object.number(key);
  if (!(value > 0.0)) object.fail(key, "must be greater than 0");
  return value;
}

int count(JsonObject& object, const std::string& key, int most) {
  return int(within(object, key, object.integer(key), 1.0, most));
}

Seed seed_in(JsonObject& object) {
  return object.has("seed")
             ? Seed(within(object, "seed", object.integer("seed"), 0.0, 2147483647.0))
             : Seed(1);
}

Eigen::Vector2d place_in(JsonObject& object, const std::string& key) {
  const auto place = object.numbers(key, 2);
  return {place[0], place[1]};
}

template <class Read>
auto entries(JsonObject& object, const std::string& key, const Read& read) {
  std::vector<decltype(read(std::declval<JsonObject>()))> result;
  for (const Json& entry : object.list(key)) {
    const std::string index = "[" + std::to_string(result.size()) + "]";
    result.push_back(read(JsonObject(entry, object.where() + "." + key + index)));
  }
  return result;
}

Material material_in(JsonObject object) {
  Material material = material_named(object.text("material"));
  std::visit(
      [&](auto& m) { m = material_from<std::decay_t<decltype(m)>>(object.object("parameters")); },
      material);
  object.finish();
  return material;
}

Light light_in(JsonObject object) {
  Light light;
  if (object.has("strength")) light.strength = strength_from(object, "strength");
  if (object.has("position_mm")) light.position = vector_from(object, "position_mm");
  if (light.position) {
    light.direction = *light.position;
  } else if (object.has("direction")) {
    light.direction = direction_from(object, "direction");
  } else {
    const double slant =
        within(object, "slant_deg", object.number("slant_deg"), 0.0, 89.0) * degree;
    const double azimuth = object.number("azimuth_deg") * degree;
    light.direction = {std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                       std::cos(slant)};
  }
  if (!(light.direction.z() > 0.0)) {
    object.fail(light.position ? "position_mm" : "direction", "must lie above the table, z > 0");
  }
  light.direction.normalize();
  object.finish();
  return light;
}

TableSphere sphere_in(JsonObject object) {
  TableSphere sphere;
  const std::string kind = object.text("kind");
  if (kind != "matte" && kind != "chrome") object.fail("kind", "must be \"matte\" or \"chrome\"");
  sphere.kind = kind == "matte" ? SphereKind::matte : SphereKind::chrome;
  sphere.place = place_in(object, "place_mm");
  sphere.diameter_mm = positive(object, "diameter_mm");
  sphere.albedo = number_within(object, "albedo", sphere.albedo, 0.0, 1.0);
  object.finish();
  return sphere;
}

// The rig, and the pitch of the fine lattice.
std::pair<Rig, double> rig_in(JsonObject object) {
  Rig rig;
  rig.pitch_mm = positive(object, "pitch_mm");
  rig.rows = count(object, "rows", 16384);
  rig.cols = count(object, "cols", 16384);
  const int oversampling = count(object, "oversampling", 64);
  if (double(rig.rows) * rig.cols * oversampling * oversampling > most_cells) {
    object.fail("oversampling", "makes more than 2^27 cells; choose a smaller one");
  }
  rig.lights = entries(object, "lights", light_in);
  if (rig.lights.empty()) object.fail("lights", "must name at least one light");
  rig.light_diameter =
      number_within(object, "light_diameter_deg", rig.light_diameter / degree, 0.01, 60.0) * degree;
  if (object.has("spheres")) rig.spheres = entries(object, "spheres", sphere_in);
  if (object.has("sheet_place_mm")) rig.sheet_place = place_in(object, "sheet_place_mm");
  rig.table_albedo = number_within(object, "table_albedo", rig.table_albedo, 0.0, 1.0);
  rig.ambient = number_within(object, "ambient", rig.ambient, 0.0, 1.0);
  rig.exposure = number_within(object, "exposure", rig.exposure, 0.0, 100.0);
  rig.read_noise = number_within(object, "read_noise", rig.read_noise, 0.0, 1.0);
  rig.shot_noise = number_within(object, "shot_noise", rig.shot_noise, 0.0, 1.0);
  if (object.has("bits")) rig.bits = object.integer("bits");
  if (rig.bits != 8 && rig.bits != 16 && rig.bits != 32) object.fail("bits", "must be 8, 16 or 32");
  rig.cast_shadows = object.flag("cast_shadows", rig.cast_shadows);
  rig.seed = seed_in(object);
  object.finish();
  return {rig, rig.pitch_mm / oversampling};
}

}  // namespace

Recipe read_recipe(const std::filesystem::path& path) {
  const Json json = read_json(path, "recipe/1");
  JsonObject object(json, path.string());
  Recipe recipe;
  recipe.name = object.text("name", path.stem().string());
  recipe.material = material_in(object.object("material"));
  double fine_pitch = 0.0;
  std::tie(recipe.rig, fine_pitch) = rig_in(object.object("rig"));

  JsonObject sheet = object.object("sheet");
  const auto cells = [&](const std::string& key) {
    return int(within(sheet, key, std::round(positive(sheet, key) / fine_pitch), 1.0, 65536.0));
  };
  const int cols = cells("width_mm");
  const int rows = cells("height_mm");
  recipe.sheet = {rows, cols, fine_pitch, Unit::mm};
  recipe.sheet_seed = seed_in(sheet);
  sheet.finish();
  object.finish();
  return recipe;
}

}  // namespace hada
