#include "studio/solid_api.h"

#include <algorithm>

#include "app/blade_side.h"
#include "app/knit_files.h"
#include "app/material_file.h"
#include "core/error.h"
#include "core/quantile.h"
#include "io/json.h"
#include "mechanics/worn_maps.h"
#include "studio/surface_bytes.h"
#include "synth/leg.h"

namespace hada {
namespace {

constexpr int side_px = 2048;  // along the blade

// What is asked for must be of this material.
template <class M>
M material_in(const Json& json, JsonObject& object) {
  object.object("file");  // an object, or an Error
  const MaterialFile file = material_of(json["file"].dump(), "the material");
  const auto* material = std::get_if<M>(&file.material);
  if (!material) throw Error("this is made of " + std::string(M::name) + "; send such a material");
  return *material;
}

Json places_of(const std::vector<Eigen::Vector3d>& places) {
  Json list = Json::array();
  for (const auto& p : places) {
    for (int k = 0; k < 3; ++k) list.push_back(float(p[k]));
  }
  return list;
}

Json json_of(const TriangleMesh& mesh) {
  Json uv = Json::array(), corners = Json::array();
  for (const auto& p : mesh.uv) {
    uv.push_back(float(p.x()));
    uv.push_back(float(p.y()));
  }
  for (const auto& t : mesh.triangles) {
    for (const int corner : t) corners.push_back(corner);
  }
  return {{"vertices", places_of(mesh.vertices_mm)}, {"uv", uv}, {"triangles", corners}};
}

std::string steel(const Json& json) {
  JsonObject object(json, "the request");
  const auto forged = material_in<Forged<>>(json, object);
  const int seed = object.integer("seed");
  if (seed < 0) object.fail("seed", "must not be negative");
  BladeLook look;
  look.hamon.height = object.number("hamon");
  if (look.hamon.height < 0.0 || look.hamon.height > 1.0) {
    object.fail("hamon", "must lie between 0 and 1");
  }
  object.finish();
  return surface_bytes(
      blade_side(forged, BladeShape{}.length_mm, side_px, look, Seed(seed)).surface);
}

// The leg and a knit on it: a place and a density for every stitch, ring after ring.
Json worn_knit(const Json& json) {
  JsonObject object(json, "the request");
  const auto knit = material_in<Knit<>>(json, object);
  WearOptions options;
  options.courses = object.integer("courses");
  options.wales = object.integer("wales");
  for (const int count : {options.courses, options.wales}) {
    if (count < 10 || count > 200) object.fail("courses", "and wales must lie between 10 and 200");
  }
  object.finish();
  options.ratio = knit.stiffness_ratio;
  options.continuity = knit.yarn_coefficient;
  options.repeat = repeat_of(knit);
  const TriangleMesh leg = leg_mesh();
  const WornKnit on_leg = worn(Body(leg), options);
  const auto density = densities(on_leg);
  return {{"leg", json_of(leg)},
          {"courses", on_leg.net.courses},
          {"wales", on_leg.net.wales},
          {"stitches", places_of(on_leg.places)},
          {"normals", places_of(on_leg.normals)},
          {"density", density},
          {"low", quantile(density, 0.02)},
          {"high", quantile(density, 0.98)},
          {"unit", "stitches per mm\u00b2"}};
}

}  // namespace

HttpResponse SolidApi::answer(const std::string& verb, const HttpRequest& request) {
  if (request.method == "GET" && verb == "blade") return {.body = json_of(blade_mesh({})).dump()};
  if (request.method == "POST" && (verb == "steel" || verb == "knit")) {
    const Json json = parsed_json(request.body, "the request");
    const std::lock_guard lock(busy_);
    if (verb == "knit") return {.body = worn_knit(json).dump()};
    return {.type = "application/octet-stream", .body = steel(json)};
  }
  throw Error("solid/" + verb + ": there is no such request");
}

}  // namespace hada
