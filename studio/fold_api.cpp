#include "studio/fold_api.h"

#include <cmath>

#include <Eigen/Geometry>

#include "app/fold_log_file.h"
#include "app/fold_model.h"
#include "app/sheet_mesh.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "studio/fold_text.h"
#include "studio/folder.h"
#include "studio/gate.h"
#include "studio/scratch.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d place(JsonObject& object, const std::string& key) {
  const auto numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

Ray ray_from(JsonObject& object) {
  Ray ray{place(object, "eye"), place(object, "way")};
  if (!(ray.way.norm() > 1e-12)) object.fail("way", "must have a length");
  return ray;
}

int parts(JsonObject& object, const std::string& key) {
  const int count = object.integer(key);
  if (count < 1 || count > 16) object.fail(key, "must lie between 1 and 16");
  return count;
}

AimOptions aim_options(JsonObject& object, const FoldSession& session) {
  AimOptions options;
  options.edge_parts = parts(object, "edge_parts");
  options.corner_parts = parts(object, "corner_parts");
  options.reach = object.number("reach");
  if (object.has("start")) options.start = place(object, "start");
  if (object.flag("chosen", false)) options.faces = chosen_now(session);
  for (const DrawnLine& line : session.state().waiting) {
    options.lines.push_back(
        {Vector3d(line.from.x(), line.from.y(), 0.0), Vector3d(line.to.x(), line.to.y(), 0.0)});
  }
  return options;
}

// What a drawn line becomes: a step of the log.
FoldStep step_of_stroke(JsonObject& object, const FoldSession& session) {
  const std::string does = object.text("does");
  const Vector3d from = place(object, "from"), to = place(object, "to");
  const Vector3d eye = place(object, "eye");
  const std::string letter = object.text("crease", "U");
  if (letter != "M" && letter != "V" && letter != "U") object.fail("crease", "must be M, V or U");
  const std::string layers = object.text("layers", "all");
  object.finish();
  if (does == "score") {
    FoldStep step;
    step.action = FoldAction::score;
    step.stroke = {eye, from, to};
    if (layers == "chosen") step.faces = session.chosen;
    return step;
  }
  for (const auto& [word, action] :
       {std::pair{"fold", FoldAction::fold}, std::pair{"crease", FoldAction::crease}}) {
    if (does == word) return step_of_line(session, action, from, to, Crease(letter[0]));
  }
  object.fail("does", "must be fold, crease or score");
}

// The ends of an axis that was drawn by hand.
std::optional<std::array<Vector2d, 2>> line_from(JsonObject& object) {
  if (!object.has("line")) return std::nullopt;
  const auto n = object.numbers("line", 4);
  const Vector2d from(n[0], n[1]), to(n[2], n[3]);
  if ((to - from).norm() < 1e-6) object.fail("line", "must join two places apart");
  return {{from, to}};
}

// What is chosen or pinned is named by a line of sight, by a place of the flat sheet, or all let
// go.
void toggle_asked(JsonObject& object, const FoldSession& session, std::vector<Vector2d>& places) {
  if (object.flag("none", false)) {
    object.finish();
    places.clear();
    return;
  }
  if (!object.has("place")) {
    const Ray ray = ray_from(object);
    object.finish();
    return toggle(session, places, ray);
  }
  const auto numbers = object.numbers("place", 2);
  object.finish();
  toggle(session, places, Vector2d(numbers[0], numbers[1]));
}

std::string hold(JsonObject& object, FoldSession& session) {
  const Ray ray = ray_from(object);
  Grip grip = taken(session, ray, line_from(object));
  const std::string layers = object.text("layers", "all");
  object.finish();
  if (layers != "all" && layers != "top" && layers != "chosen") {
    object.fail("layers", "must be all, top or chosen");
  }
  if (grip.step.action == FoldAction::turn) {
    if (layers == "chosen") {
      throw Error("chosen layers turn about a crease; draw one instead of an axis");
    }
    const int seen_from_above = ray.way.z() < 0.0 ? 1 : -1;
    grip.step.layers = layers == "all" ? 0 : seen_from_above;
  } else {
    grip.step.layers = layers == "all" ? 0 : 1;
    if (layers == "chosen") grip.step.faces = session.chosen;
    grip.step.pins = session.pins;
  }
  session.dragged.reset();
  session.grip = std::move(grip);
  return fold_grip_text(*session.grip, should_turn_view(session.grip->along, ray));
}

}  // namespace

std::string FoldApi::change(const std::string& verb, const std::string& body) {
  const Json json = parsed_json(body, "the request");
  JsonObject object(json, "the request");
  if (verb == "aim") {
    const Ray ray = ray_from(object);
    const AimOptions options = aim_options(object, session_);
    object.finish();
    return fold_aim_text(aim(session_.state().sheet, session_.stack(), ray, options));
  }
  if (verb == "hold") return hold(object, session_);
  if (verb == "drag") {
    const Ray ray = ray_from(object);
    const double whole = object.number("whole", 0.0);
    object.finish();
    drag(session_, ray, whole);
    return fold_drag_text(session_);
  }
  if (verb == "between") {
    const int at = object.integer("at");
    const double share = object.number("share");
    object.finish();
    return fold_shape_text(between(session_, at, share), share);
  }
  if (verb == "pin" || verb == "choose") {
    toggle_asked(object, session_, verb == "pin" ? session_.pins : session_.chosen);
  } else if (verb == "drop") {
    object.finish();
    const bool turned = session_.dragged && session_.grip->step.degrees != 0.0;
    if (turned) session_.add(FoldStep(session_.grip->step));
    session_.grip.reset();
    session_.dragged.reset();
  } else if (verb == "stroke") {
    session_.add(step_of_stroke(object, session_));
  } else if (verb == "do") {
    const FoldStep step = fold_step_of(body, "the step");
    session_.add(step);
    // Chosen faces are cut by it: what is left of them is chosen anew.
    if (step.action == FoldAction::through && !step.faces.empty()) session_.chosen.clear();
  } else if (verb == "go") {
    const int at = object.integer("at");
    object.finish();
    session_.go_to(at);
  } else if (verb == "new") {
    object.finish();
    session_ = FoldSession();
  } else if (verb == "log") {
    session_ = FoldSession(fold_log_of(body, "the log"));
  } else if (verb == "open") {
    const std::string name = object.text("name");
    object.finish();
    FoldLog log = fold_log_of(text_within(folder_, name), name);
    if (log.title.empty()) log.title = std::filesystem::path(name).stem().string();
    session_ = FoldSession(std::move(log));
  } else {
    throw Error("fold/" + verb + ": there is no such request");
  }
  return fold_state_text(session_);
}

HttpResponse FoldApi::exported(const std::string& format) const {
  const std::string name = session_.log().title.empty() ? "sheet" : session_.log().title;
  if (format == "log") return download(name + ".json", fold_log_text(session_.done()));
  if (format == "fold") {
    return download(name + ".fold", fold_text(fold_model(name, session_.state())));
  }
  if (format == "frames") {
    return download(name + ".fold", fold_text(fold_sequence(name, session_.states())));
  }
  if (format != "glb" && format != "obj" && format != "stl") {
    throw Error("a sheet is exported as log, fold, frames, glb, obj or stl");
  }
  const Scratch scratch;
  const auto path = scratch.path() / ("sheet." + format);
  const FoldFrame frame = fold_model(name, session_.state()).frames[0];
  write_mesh(path, mesh_of(frame, paper_thickness(frame)));
  return download(name + "." + format, text_of_file(path));
}

HttpResponse FoldApi::answer(const std::string& verb, const HttpRequest& request) {
  const std::lock_guard lock(busy_);
  if (request.method == "GET") {
    if (verb == "state") return {.body = fold_state_text(session_)};
    if (verb == "export") return exported(request.word("as"));
    throw Error("fold/" + verb + ": there is no such request");
  }
  return {.body = change(verb, request.body)};
}

}  // namespace hada
