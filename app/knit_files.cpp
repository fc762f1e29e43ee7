#include "app/knit_files.h"

#include <cmath>
#include <variant>

#include "app/material_file.h"
#include "core/error.h"
#include "io/json.h"

namespace hada {
namespace {

constexpr int most_points = 1000000;

KnitCrossings::State state_from(JsonObject object, int points) {
  KnitCrossings::State state;
  state.pull = pull_named(object.text("along"));
  state.stretch = object.number("stretch");
  if (!(state.stretch > 0.0)) object.fail("stretch", "must be greater than 0");
  const Json& places = object.list("places_mm");
  if (int(places.size()) != points) {
    object.fail("places_mm", "must have courses x wales = " + std::to_string(points) + " places");
  }
  for (const Json& place : places) {
    if (place.is_null()) {  // not seen
      state.places_mm.push_back(Eigen::Vector3d::Constant(NAN));
      continue;
    }
    if (!place.is_array() || place.size() != 2 || !place[0].is_number() || !place[1].is_number()) {
      object.fail("places_mm",
                  "must hold pairs of numbers, [x, y], or null where one was not seen");
    }
    state.places_mm.emplace_back(place[0].get<double>(), place[1].get<double>(), 0.0);
    if (!state.places_mm.back().allFinite()) object.fail("places_mm", "must be finite");
  }
  object.finish();
  return state;
}

}  // namespace

KnitPull pull_named(const std::string& name) {
  if (name == "wale") return KnitPull::wale;
  if (name == "course") return KnitPull::course;
  throw Error("\"" + name + "\" is no direction of a pull: it is along \"wale\" or \"course\"");
}

KnitClamp clamp_named(const std::string& name) {
  if (name == "uniform") return KnitClamp::uniform;
  if (name == "three-points") return KnitClamp::three_points;
  throw Error("\"" + name + "\" is no clamp: it is \"uniform\" or \"three-points\"");
}

KnitCrossings read_crossings(const std::filesystem::path& path) {
  const Json json = read_json(path, "knit_crossings/1");
  JsonObject object(json, path.string());
  KnitCrossings crossings;
  KnitNet& net = crossings.net;
  net.courses = object.integer("courses");
  net.wales = object.integer("wales");
  if (net.courses < 3 || net.wales < 3 || net.courses > most_points ||
      net.wales > most_points / net.courses) {
    throw Error(path.string() +
                ": courses and wales must be 3 at least, a million crossings in all");
  }
  net.wale_length = object.number("wale_mm");
  net.course_length = object.number("course_mm");
  if (!(net.wale_length > 0.0) || !(net.course_length > 0.0)) {
    throw Error(path.string() + ": wale_mm and course_mm, at rest, must be greater than 0");
  }
  crossings.clamp = clamp_named(object.text("clamp"));
  const std::string frame = object.text("frame", "clamps");
  if (frame != "clamps" && frame != "picture") object.fail("frame", "must be clamps or picture");
  crossings.frame_known = frame == "clamps";
  crossings.repeat.clear();
  for (const Json& yarn : object.list("repeat")) {
    if (!yarn.is_number_integer()) object.fail("repeat", "must hold 0 (nylon) and 1 (support)");
    crossings.repeat.push_back(yarn.get<int>());
  }
  if (crossings.repeat.empty()) object.fail("repeat", "must name the yarn of one course at least");
  const Json& states = object.list("states");
  for (std::size_t i = 0; i < states.size(); ++i) {
    crossings.states.push_back(
        state_from(JsonObject(states[i], path.string() + ": states[" + std::to_string(i) + "]"),
                   net.points()));
  }
  object.finish();
  return crossings;
}

std::string crossings_text(const KnitCrossings& crossings) {
  const KnitNet& net = crossings.net;
  Json json = {{"hada", "knit_crossings/1"},
               {"courses", net.courses},
               {"wales", net.wales},
               {"wale_mm", net.wale_length},
               {"course_mm", net.course_length},
               {"clamp", crossings.clamp == KnitClamp::uniform ? "uniform" : "three-points"},
               {"frame", crossings.frame_known ? "clamps" : "picture"},
               {"repeat", crossings.repeat},
               {"states", Json::array()}};
  for (const auto& state : crossings.states) {
    Json places = Json::array();
    for (const auto& p : state.places_mm) {
      places.push_back(p.allFinite() ? Json({p.x(), p.y()}) : Json());
    }
    json["states"].push_back({{"along", state.pull == KnitPull::wale ? "wale" : "course"},
                              {"stretch", state.stretch},
                              {"places_mm", places}});
  }
  return json.dump() + "\n";
}

Knit<> read_knit(const std::filesystem::path& path) {
  const MaterialFile file = read_material(path);
  const auto* knit = std::get_if<Knit<>>(&file.material);
  if (!knit) throw Error(path.string() + ": is not a material file of \"knit\"");
  return *knit;
}

std::vector<int> repeat_of(const Knit<>& knit) {
  std::vector<int> repeat;
  bool second = false;
  for (const double yarn : knit.colour_repeat) {
    repeat.push_back(yarn > 0.5 ? 1 : 0);
    second = second || repeat.back() == 1;
  }
  return second ? repeat : std::vector<int>{0, 1};
}

}  // namespace hada
