#include "app/fold_log_file.h"

#include <array>
#include <cmath>
#include <string_view>

#include "io/json.h"

namespace hada {
namespace {

struct Name {
  FoldAction action;
  std::string_view word;
};

constexpr std::array<Name, 9> names{{{FoldAction::crease, "crease"},
                                     {FoldAction::fold, "fold"},
                                     {FoldAction::flatten, "flatten"},
                                     {FoldAction::through, "through"},
                                     {FoldAction::turn, "turn"},
                                     {FoldAction::squash, "squash"},
                                     {FoldAction::over, "over"},
                                     {FoldAction::score, "score"},
                                     {FoldAction::swing, "swing"}}};

bool has_line(FoldAction action) {
  return action != FoldAction::flatten && action != FoldAction::squash &&
         action != FoldAction::over && action != FoldAction::score;
}

FoldAction action_named(JsonObject& object) {
  const std::string word = object.text("do");
  std::string known;
  for (const Name& name : names) {
    if (name.word == word) return name.action;
    known += (known.empty() ? "" : ", ") + std::string(name.word);
  }
  object.fail("do", "is no step; known are " + known);
}

Eigen::Vector2d place(JsonObject& object, const std::string& key) {
  const auto numbers = object.numbers(key, 2);
  return {numbers[0], numbers[1]};
}

Eigen::Vector3d place_in_space(JsonObject& object, const std::string& key) {
  const auto numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<Eigen::Vector2d> places(JsonObject& object, const std::string& key) {
  std::vector<Eigen::Vector2d> found;
  if (!object.has(key)) return found;
  for (const Json& entry : object.list(key)) {
    const Json named{{key, entry}};
    JsonObject one(named, object.where());
    found.push_back(place(one, key));
  }
  return found;
}

int layers_from(JsonObject& object, std::initializer_list<std::string_view> words) {
  const std::string layers = object.text("layers", "all");
  int value = 0;
  std::string known;
  for (const std::string_view word : words) {
    if (layers == word) return word == "bottom" ? -1 : value;
    known += (known.empty() ? "" : ", ") + std::string(word);
    ++value;
  }
  object.fail("layers", "must be one of " + known);
}

FoldStep step_from(JsonObject object) {
  FoldStep step;
  step.action = action_named(object);
  if (has_line(step.action)) {
    step.from = place(object, "from");
    step.to = place(object, "to");
    if ((step.to - step.from).norm() < 1e-9) object.fail("to", "must lie apart from \"from\"");
  }
  if (step.action == FoldAction::over) step.from.x() = object.number("x", 0.0);
  if (step.action == FoldAction::fold) {
    const std::string letter = object.text("crease", "U");
    if (letter != "M" && letter != "V" && letter != "U" && letter != "F") {
      object.fail("crease", "must be M, V, U or F");
    }
    step.crease = Crease(letter[0]);
  }
  if (step.action == FoldAction::through) {
    step.stiff = object.flag("stiff", false);
    step.mountains = places(object, "mountains");
    step.valleys = places(object, "valleys");
  }
  if (step.action == FoldAction::turn) {
    step.degrees = object.number("degrees");
    step.layers = layers_from(object, {"all", "top", "bottom"});
  }
  if (step.action == FoldAction::swing) {
    step.degrees = object.number("degrees");
    step.layers = layers_from(object, {"all", "flap"});
    step.pins = places(object, "pins");
  }
  if (step.action == FoldAction::score) {
    step.stroke = {place_in_space(object, "eye"), place_in_space(object, "from"),
                   place_in_space(object, "to")};
  }
  if (step.action == FoldAction::swing || step.action == FoldAction::score ||
      step.action == FoldAction::through) {
    step.faces = places(object, "faces");
  }
  if (std::abs(step.degrees) > 360.0) object.fail("degrees", "must lie between -360 and 360");
  if (step.action == FoldAction::squash) step.share = object.number("share", step.share);
  if (step.share < 0.0 || step.share > 1.0) object.fail("share", "must lie between 0 and 1");
  step.note = object.text("note", "");
  object.finish();
  return step;
}

void put_places(Json& entry, const char* key, const std::vector<Eigen::Vector2d>& places) {
  for (const Eigen::Vector2d& place : places) entry[key].push_back({place.x(), place.y()});
}

}  // namespace

FoldStep fold_step_of(const std::string& text, const std::string& where) {
  const Json json = parsed_json(text, where);
  return step_from(JsonObject(json, where));
}

FoldLog fold_log_of(const std::string& text, const std::string& where) {
  const Json json = json_of_kind(text, where, "fold_log/1");
  JsonObject object(json, where);
  FoldLog log;
  log.title = object.text("title", "");
  log.side = object.number("side", 1.0);
  if (!(log.side > 0.0)) object.fail("side", "must be greater than 0");
  const Json& steps = object.list("steps");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    log.steps.push_back(
        step_from(JsonObject(steps[i], where + ": steps[" + std::to_string(i) + "]")));
  }
  object.finish();
  return log;
}

FoldLog read_fold_log(const std::filesystem::path& path) {
  FoldLog log = fold_log_of(text_of_file(path), path.string());
  if (log.title.empty()) log.title = path.stem().string();
  return log;
}

std::string fold_log_text(const FoldLog& log) {
  Json json = {{"hada", "fold_log/1"}, {"title", log.title}, {"side", log.side}};
  Json& steps = json["steps"] = Json::array();
  for (const FoldStep& step : log.steps) {
    Json entry = Json::object();
    for (const Name& name : names) {
      if (name.action == step.action) entry["do"] = name.word;
    }
    if (has_line(step.action)) {
      entry["from"] = {step.from.x(), step.from.y()};
      entry["to"] = {step.to.x(), step.to.y()};
    }
    if (step.stiff) entry["stiff"] = true;
    if (step.action == FoldAction::over) entry["x"] = step.from.x();
    if (step.action == FoldAction::fold) entry["crease"] = std::string(1, char(step.crease));
    if (step.action == FoldAction::turn) {
      entry["degrees"] = step.degrees;
      entry["layers"] = step.layers == 0 ? "all" : step.layers > 0 ? "top" : "bottom";
    }
    if (step.action == FoldAction::swing) {
      entry["degrees"] = step.degrees;
      entry["layers"] = step.layers == 0 ? "all" : "flap";
      put_places(entry, "pins", step.pins);
    }
    if (step.action == FoldAction::score) {
      const FoldStroke& stroke = step.stroke;
      entry["eye"] = {stroke.eye.x(), stroke.eye.y(), stroke.eye.z()};
      entry["from"] = {stroke.from.x(), stroke.from.y(), stroke.from.z()};
      entry["to"] = {stroke.to.x(), stroke.to.y(), stroke.to.z()};
    }
    put_places(entry, "faces", step.faces);
    put_places(entry, "mountains", step.mountains);
    put_places(entry, "valleys", step.valleys);
    if (step.action == FoldAction::squash) entry["share"] = step.share;
    if (!step.note.empty()) entry["note"] = step.note;
    steps.push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

}  // namespace hada
