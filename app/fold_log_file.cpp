#include "app/fold_log_file.h"

#include <array>
#include <string_view>

#include "io/json.h"

namespace hada {
namespace {

struct Name {
  FoldAction action;
  std::string_view word;
};

constexpr std::array<Name, 7> names{{{FoldAction::crease, "crease"},
                                     {FoldAction::fold, "fold"},
                                     {FoldAction::flatten, "flatten"},
                                     {FoldAction::through, "through"},
                                     {FoldAction::turn, "turn"},
                                     {FoldAction::squash, "squash"},
                                     {FoldAction::over, "over"}}};

bool has_line(FoldAction action) {
  return action != FoldAction::flatten && action != FoldAction::squash &&
         action != FoldAction::over;
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
  if (step.action == FoldAction::turn) {
    step.degrees = object.number("degrees");
    const std::string layers = object.text("layers", "all");
    if (layers != "all" && layers != "top" && layers != "bottom") {
      object.fail("layers", "must be all, top or bottom");
    }
    step.layers = layers == "all" ? 0 : layers == "top" ? 1 : -1;
  }
  if (step.action == FoldAction::squash) step.share = object.number("share", step.share);
  step.note = object.text("note", "");
  object.finish();
  return step;
}

}  // namespace

FoldLog read_fold_log(const std::filesystem::path& path) {
  const Json json = read_json(path, "fold_log/1");
  JsonObject object(json, path.string());
  FoldLog log;
  log.title = object.text("title", path.stem().string());
  log.side = object.number("side", 1.0);
  if (!(log.side > 0.0)) object.fail("side", "must be greater than 0");
  const Json& steps = object.list("steps");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    log.steps.push_back(
        step_from(JsonObject(steps[i], path.string() + ": steps[" + std::to_string(i) + "]")));
  }
  object.finish();
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
    if (step.action == FoldAction::over) entry["x"] = step.from.x();
    if (step.action == FoldAction::fold) entry["crease"] = std::string(1, char(step.crease));
    if (step.action == FoldAction::turn) {
      entry["degrees"] = step.degrees;
      entry["layers"] = step.layers == 0 ? "all" : step.layers > 0 ? "top" : "bottom";
    }
    if (step.action == FoldAction::squash) entry["share"] = step.share;
    if (!step.note.empty()) entry["note"] = step.note;
    steps.push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

}  // namespace hada
