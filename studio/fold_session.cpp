#include "studio/fold_session.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "sheet/places.h"
#include "sheet/pointer.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t most_steps = 1000;
constexpr int most_faces = 4000;

std::string name_of_step(const FoldLog& log, std::size_t step) {
  return (log.title.empty() ? std::string("sheet") : log.title) + ": step " +
         std::to_string(step + 1);
}

FoldState checked(FoldState state, const std::string& where) {
  if (state.sheet.faces() > most_faces) {
    throw Error(where + ": leads to more than " + std::to_string(most_faces) + " faces");
  }
  return state;
}

Vector3d centre_of(const Sheet& sheet, int face) {
  Vector3d sum = Vector3d::Zero();
  const auto corners = sheet.corners_of(face);
  for (const int v : corners) sum += sheet.folded[std::size_t(v)];
  return sum / double(corners.size());
}

void put_axis(Grip& grip, const Vector3d& from, const Vector3d& to) {
  grip.axis = {from, to};
  grip.on_axis = from;
  grip.along = (to - from).normalized();
}

}  // namespace

FoldSession::FoldSession(FoldLog log) : log_(std::move(log)) {
  if (log_.steps.size() > most_steps) {
    throw Error("the log has more than " + std::to_string(most_steps) + " steps; shorten it");
  }
  FoldState square;
  square.sheet = square_sheet(log_.side);
  states_ = {std::move(square)};
  for (std::size_t i = 0; i < log_.steps.size(); ++i) {
    const std::string where = name_of_step(log_, i);
    states_.push_back(checked(folded_on(states_.back(), log_.steps[i], where), where));
  }
  at_ = int(log_.steps.size());
  look();
}

FoldLog FoldSession::done() const {
  FoldLog log = log_;
  log.steps.resize(std::size_t(at_));
  return log;
}

bool FoldSession::is_open() const {
  const Sheet& sheet = state().sheet;
  for (std::size_t v = 0; v < sheet.flat.size(); ++v) {
    if (std::abs(sheet.folded[v].z()) > 1e-9) return false;
    if ((sheet.folded[v].head<2>() - sheet.flat[v]).norm() > 1e-9) return false;
  }
  return true;
}

void FoldSession::add(const FoldStep& step) {
  if (std::size_t(at_) >= most_steps) throw Error("the log is full; begin a new sheet");
  const std::string where = name_of_step(log_, std::size_t(at_));
  FoldState next = checked(folded_on(state(), step, where), where);
  log_.steps.resize(std::size_t(at_));
  states_.resize(std::size_t(at_) + 1);
  log_.steps.push_back(step);
  states_.push_back(std::move(next));
  ++at_;
  look();
}

void FoldSession::go_to(int at) {
  at_ = std::clamp(at, 0, int(log_.steps.size()));
  look();
}

void FoldSession::look() {
  grip.reset();
  dragged.reset();
  stack_ = stack_of(state().sheet, state().order);
}

Grip taken(const FoldSession& session, const Ray& ray,
           const std::optional<std::array<Vector2d, 2>>& line) {
  const Sheet& sheet = session.state().sheet;
  const auto found = seen(sheet, session.stack(), ray);
  if (!found) throw Error("there is no paper under the pointer");
  Grip grip;
  grip.face = found->face;
  grip.click = found->place;
  grip.centre = centre_of(sheet, found->face);
  if (line) {
    auto [from, to] = *line;
    const Vector2d way = to - from, there = grip.click.head<2>() - from;
    // What is held is what turns: it lies to the left.
    if (way.x() * there.y() - way.y() * there.x() < 0.0) std::swap(from, to);
    grip.step.action = FoldAction::turn;
    grip.step.from = from;
    grip.step.to = to;
    put_axis(grip, {from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0});
    return grip;
  }
  const int edge = axis_of_click(sheet, found->face, found->place);
  if (edge < 0) throw Error("this face has no crease to turn about; draw one, or an axis");
  const int half = sheet.half(2 * edge).face == found->face ? 2 * edge : 2 * edge + 1;
  const std::size_t a = std::size_t(sheet.origin(half)), b = std::size_t(sheet.target(half));
  grip.step.action = FoldAction::swing;
  grip.step.from = flat_place(sheet, found->face, found->place);
  grip.step.to = 0.5 * (sheet.flat[a] + sheet.flat[b]);
  put_axis(grip, sheet.folded[a], sheet.folded[b]);
  return grip;
}

void drag(FoldSession& session, const Ray& ray, double whole_deg) {
  if (!session.grip) throw Error("nothing is held; press on a face first");
  Grip& grip = *session.grip;
  const auto angle = angle_of_drag(grip.on_axis, grip.along, grip.click, ray);
  if (!angle) return;
  double degrees = *angle * 180.0 / std::numbers::pi;
  if (whole_deg > 0.0) degrees = whole_deg * std::round(degrees / whole_deg);
  if (grip.step.action == FoldAction::turn) {
    grip.step.degrees = degrees;
    session.dragged = folded_on(session.state(), grip.step, "drag");
    return;
  }
  // On from where it is: linked faces follow a small turn in a few steps, as far as paper goes.
  if (!grip.swing) {
    grip.swing.emplace(with_lines_drawn(session.state(), "drag"), grip.step, true, "drag");
  }
  grip.swing->further(degrees - grip.swing->degrees());
  grip.step.degrees = grip.swing->degrees();
  session.dragged = grip.swing->state();
}

std::vector<int> chosen_now(const FoldSession& session) {
  std::vector<int> faces;
  for (const Vector2d& place : session.chosen) {
    const int face = face_at(session.state().sheet, place);
    if (face >= 0) faces.push_back(face);
  }
  return faces;
}

void toggle(const FoldSession& session, std::vector<Vector2d>& places, const Vector2d& place) {
  const Sheet& sheet = session.state().sheet;
  const int face = face_at(sheet, place);
  if (face < 0) throw Error("this place is beside the sheet");
  const auto removed =
      std::erase_if(places, [&](const Vector2d& known) { return face_at(sheet, known) == face; });
  if (removed == 0) places.push_back(place);
}

void toggle(const FoldSession& session, std::vector<Vector2d>& places, const Ray& ray) {
  const Sheet& sheet = session.state().sheet;
  const auto found = seen(sheet, session.stack(), ray);
  if (!found) throw Error("there is no paper under the pointer");
  toggle(session, places, flat_place(sheet, found->face, found->place));
}

FoldState between(const FoldSession& session, int at, double share) {
  if (at < 1 || at > int(session.log().steps.size())) throw Error("there is no such step");
  FoldStep step = session.log().steps[std::size_t(at - 1)];
  const FoldState& before = session.state_after(at - 1);
  share = std::clamp(share, 0.0, 1.0);
  if (step.action == FoldAction::over) {
    FoldState state = before;
    const Vector3d axis(step.from.x(), 0.0, 0.0);
    const Eigen::AngleAxisd turn(share * std::numbers::pi, Vector3d::UnitY());
    for (Vector3d& p : state.sheet.folded) p = axis + turn * (p - axis);
    return state;
  }
  const bool turns = step.action == FoldAction::turn || step.action == FoldAction::swing ||
                     step.action == FoldAction::through;
  if (!turns || share == 1.0) return share < 0.5 ? before : session.state_after(at);
  // Folding through is turning by half a turn; how layers pass each other is not shown.
  if (step.action == FoldAction::through) step.action = FoldAction::turn;
  step.degrees *= share;
  return folded_on(before, step, "between");
}

FoldStep step_of_line(const FoldSession& session, FoldAction action, const Vector3d& from,
                      const Vector3d& to, Crease crease) {
  if (!session.is_open()) {
    throw Error("the sheet is folded; lines of the pattern are drawn while it is open");
  }
  if ((to - from).norm() < 1e-6) throw Error("the line is too short; drag further");
  FoldStep step;
  step.action = action;
  step.from = from.head<2>();
  step.to = to.head<2>();
  step.crease = crease;
  return step;
}

}  // namespace hada
