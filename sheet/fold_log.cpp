#include "sheet/fold_log.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/error.h"
#include "sheet/arrangement.h"
#include "sheet/crease.h"
#include "sheet/fold_through.h"
#include "sheet/folded_flat.h"
#include "sheet/held_swing.h"
#include "sheet/kept_order.h"
#include "sheet/places.h"
#include "sheet/pointer.h"
#include "sheet/relaxed.h"
#include "sheet/simulate.h"
#include "sheet/turn_layers.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Opens the sheet and puts lines on it; where one lies on an older one it takes its place.
void draw(Sheet& sheet, const std::vector<DrawnLine>& lines, const std::string& where) {
  FoldFrame frame;
  const auto add = [&](const Vector2d& from, const Vector2d& to, Crease crease) {
    const int first = int(frame.vertices.size());
    frame.vertices.emplace_back(from.x(), from.y(), 0.0);
    frame.vertices.emplace_back(to.x(), to.y(), 0.0);
    frame.edges.push_back({first, first + 1});
    frame.assignment.push_back(crease);
  };
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    add(line->from, line->to, line->crease);
  }
  for (int e = 0; e < sheet.edges(); ++e) {
    add(sheet.flat[std::size_t(sheet.origin(2 * e))], sheet.flat[std::size_t(sheet.target(2 * e))],
        sheet.creases[std::size_t(e)]);
  }
  sheet = sheet_of(frame, where);
}

void squash(FoldState& state, const FoldStep& step) {
  Sheet& sheet = state.sheet;
  const auto before = sheet.folded;
  for (Vector3d& p : sheet.folded) p.z() *= step.share;
  sheet.folded = stiffened(sheet).places;
  sheet.fold_angles = edge_angles(sheet, sheet.folded);
  settle_moved(state, before);
}

void turn_over(FoldState& state, const FoldStep& step) {
  for (Vector3d& p : state.sheet.folded) p = {2.0 * step.from.x() - p.x(), p.y(), -p.z()};
}

void score(FoldState& state, const FoldStep& step, const std::string& where) {
  const FoldStroke& stroke = step.stroke;
  const auto chosen = chosen_faces(state.sheet, step.faces, where);
  const int before = state.sheet.faces();
  const CreaseCut cut =
      drawn_cut({stroke.eye, stroke.from - stroke.eye}, {stroke.eye, stroke.to - stroke.eye});
  const auto creases = insert_crease(state.sheet, state.sheet.folded, cut, Crease::flat, chosen);
  if (creases.empty()) throw Error(where + ": the line crosses no face from side to side");
  state.order = split_orders(state.sheet, state.order, before, creases);
}

void swing_face(FoldState& state, const FoldStep& step, const std::string& where) {
  HeldSwing held(std::move(state), step, false, where);
  held.further(step.degrees);
  if (held.stuck()) {
    throw Error(where + ": the paper would stretch; what the face hangs on cannot follow so far");
  }
  state = held.state();
}

}  // namespace

FoldState with_lines_drawn(FoldState state, const std::string& where) {
  if (state.waiting.empty()) return state;
  draw(state.sheet, state.waiting, where);
  state.waiting.clear();
  state.order.clear();  // opened, no face lies on another
  return state;
}

FoldState folded_on(FoldState state, const FoldStep& step, const std::string& where) {
  const bool draws = step.action == FoldAction::crease || step.action == FoldAction::fold;
  if (!draws) state = with_lines_drawn(std::move(state), where);
  state.contact.reset();
  switch (step.action) {
    case FoldAction::crease:
      state.waiting.push_back({step.from, step.to, Crease::flat});
      break;
    case FoldAction::fold:
      state.waiting.push_back({step.from, step.to, step.crease});
      break;
    case FoldAction::flatten:
      flatten(state, where);
      break;
    case FoldAction::through:
      fold_through(state, step, where);
      break;
    case FoldAction::turn:
      turn_layers(state, step, where);
      break;
    case FoldAction::squash:
      squash(state, step);
      break;
    case FoldAction::over:
      turn_over(state, step);
      break;
    case FoldAction::score:
      score(state, step, where);
      break;
    case FoldAction::swing:
      swing_face(state, step, where);
      break;
  }
  return state;
}

std::vector<FoldState> replayed(const FoldLog& log) {
  FoldState square;
  square.sheet = square_sheet(log.side);
  std::vector<FoldState> states{std::move(square)};
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    const std::string where = log.title + ": step " + std::to_string(i + 1);
    states.push_back(folded_on(states.back(), log.steps[i], where));
  }
  return states;
}

}  // namespace hada
