#include "studio/fold_text.h"

#include <numbers>

#include "app/fold_log_file.h"
#include "io/json.h"
#include "sheet/crossing.h"
#include "sheet/places.h"
#include "sheet/strain.h"

namespace hada {
namespace {

Json json_of(const Eigen::Vector3d& place) {
  return Json::array({place.x(), place.y(), place.z()});
}

// Numbers one behind the other, as a page wants them for its buffers.
Json flat_list(const std::vector<Eigen::Vector3d>& places) {
  Json numbers = Json::array();
  for (const auto& p : places) {
    for (int i = 0; i < 3; ++i) numbers.push_back(p[i]);
  }
  return numbers;
}

Json with_most(const std::vector<double>& of_faces) {
  double most = 0.0;
  for (const double value : of_faces) most = std::max(most, value);
  return {{"most", most}, {"faces", of_faces}};
}

Json piles_json(const Stack& stack) {
  return {{"level", stack.level}, {"up", flat_list(stack.up)}};
}

void put_shape(Json& json, const Sheet& sheet, const Stack& stack) {
  json["vertices"] = flat_list(sheet.folded);
  json["piles"] = piles_json(stack);
  json["strain"] = with_most(face_strains(sheet));
  json["planarity"] = with_most(face_planarities(sheet));
  Json& faces = json["faces"] = Json::array();
  for (int f = 0; f < sheet.faces(); ++f) faces.push_back(sheet.corners_of(f));
}

// Where a place of the flat sheet lies now.
Json place_now(const Sheet& sheet, const Eigen::Vector2d& flat) {
  const int face = face_at(sheet, flat);
  return face < 0 ? Json() : json_of(folded_place(sheet, face, flat));
}

const char* word_of(Drawn by) {
  switch (by) {
    case Drawn::vertex:
      return "vertex";
    case Drawn::crossing:
      return "crossing";
    case Drawn::division:
      return "division";
    case Drawn::direction:
      return "direction";
    case Drawn::paper:
      return "paper";
    case Drawn::ground:
      return "ground";
  }
  return "";
}

}  // namespace

std::string fold_state_text(const FoldSession& session) {
  const FoldState& state = session.state();
  const Sheet& sheet = state.sheet;
  Json json = {{"hada", "fold_state/1"},
               {"title", session.log().title},
               {"side", session.log().side},
               {"at", session.at()},
               {"log", Json::parse(fold_log_text(session.log()))["steps"]},
               {"flat", state.flat},
               {"open", session.is_open()},
               {"crossing_pairs", crossing_faces(sheet).size()}};
  put_shape(json, sheet, session.stack());
  Json& flat = json["flat_vertices"] = Json::array();
  for (const auto& p : sheet.flat) flat.push_back({p.x(), p.y()});
  Json& edges = json["edges"] = Json::array();
  for (int e = 0; e < sheet.edges(); ++e) {
    edges.push_back({{"from", sheet.origin(2 * e)},
                     {"to", sheet.target(2 * e)},
                     {"crease", std::string(1, char(sheet.creases[std::size_t(e)]))},
                     {"degrees", sheet.fold_angles[std::size_t(e)] * 180.0 / std::numbers::pi}});
  }
  Json& waiting = json["waiting"] = Json::array();
  for (const DrawnLine& line : state.waiting) {
    waiting.push_back({{"from", {line.from.x(), line.from.y()}},
                       {"to", {line.to.x(), line.to.y()}},
                       {"crease", std::string(1, char(line.crease))}});
  }
  Json& pins = json["pins"] = Json::array();
  for (const auto& pin : session.pins) pins.push_back(place_now(sheet, pin));
  json["chosen"] = chosen_now(session);
  Json& chosen = json["chosen_places"] = Json::array();
  for (const auto& place : session.chosen) chosen.push_back({place.x(), place.y()});
  return json.dump();
}

std::string fold_drag_text(const FoldSession& session) {
  if (!session.dragged) return fold_shape_text(session.state(), 0.0);
  return fold_shape_text(*session.dragged, session.grip->step.degrees);
}

std::string fold_shape_text(const FoldState& state, double degrees) {
  Json json = {{"degrees", degrees}, {"met", state.contact.has_value()}};
  put_shape(json, state.sheet, stack_of(state.sheet, state.order));
  return json.dump();
}

std::string fold_grip_text(const Grip& grip, bool turns_view) {
  return Json{{"face", grip.face},
              {"axis", {json_of(grip.axis[0]), json_of(grip.axis[1])}},
              {"click", json_of(grip.click)},
              {"centre", json_of(grip.centre)},
              {"turn_view", turns_view}}
      .dump();
}

std::string fold_aim_text(const std::optional<Aim>& aim) {
  if (!aim) return "null";
  Json json = {{"place", json_of(aim->place)}, {"by", word_of(aim->by)}, {"face", aim->face}};
  Json& guides = json["guides"] = Json::array();
  for (const Stretch& guide : aim->guides) guides.push_back({json_of(guide[0]), json_of(guide[1])});
  Json& points = json["points"] = Json::array();
  for (const auto& point : aim->points) points.push_back(json_of(point));
  return json.dump();
}

}  // namespace hada
