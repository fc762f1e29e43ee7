#include "sheet/fold_log.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "mechanics/bar_network.h"
#include "sheet/arrangement.h"
#include "sheet/crease.h"
#include "sheet/flaps.h"
#include "sheet/folded_flat.h"
#include "sheet/layers.h"
#include "sheet/places.h"
#include "sheet/pointer.h"
#include "sheet/simulate.h"
#include "sheet/swing.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tolerance = 1e-9;

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

int first_staying(const std::vector<bool>& moving) {
  return int(std::find(moving.begin(), moving.end(), false) - moving.begin());
}

void fold_through(FoldState& state, const FoldStep& step, const std::string& where) {
  if (!state.flat) throw Error(where + ": the sheet is not flat; flatten it first");
  Sheet& sheet = state.sheet;
  const CreaseCut cut = straight_cut(step.from, step.to, tolerance);
  const auto creases = insert_crease(sheet, sheet.folded, cut, Crease::flat);
  const auto moving = moving_faces(sheet, creases, cut, where);
  for (const int e : creases) {
    Crease& crease = sheet.creases[std::size_t(e)];
    crease = is_folded(crease) ? Crease::flat : Crease::unassigned;
  }
  // Within what moves, folds may turn inside out, as in a reverse fold.
  for (int e = 0; e < sheet.edges(); ++e) {
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (a < 0 || b < 0 || !moving[std::size_t(a)] || !moving[std::size_t(b)]) continue;
    Crease& crease = sheet.creases[std::size_t(e)];
    if (is_folded(crease)) crease = Crease::unassigned;
  }
  flatten(state, where, first_staying(moving));
}

// Flaps that are tucked into each other are pulled apart: another order of layers in which one flap
// lies outside the others, with the same mountains and valleys or, if need be, with others.
int freed_flap(FoldState& state, const std::vector<int>& flap, int side) {
  const int flaps = 1 + *std::max_element(flap.begin(), flap.end());
  FlatState flat = flat_state(state.sheet);
  keep_in_place(flat, state.sheet, 0);
  for (const bool refold : {false, true}) {
    Sheet sheet = state.sheet;
    for (Crease& crease : sheet.creases) {
      if (refold && is_folded(crease)) crease = Crease::unassigned;
    }
    for (int k = 0; k < flaps; ++k) {
      LayerOptions options;
      options.count = false;
      int overlaps = 0;
      for (const FaceOrder& o : state.order) {
        const int a = flap[std::size_t(o.face)], b = flap[std::size_t(o.other)];
        if (a < 0 || b < 0 || a == b || (a != k && b != k)) continue;
        const bool a_above = (a == k) == (side > 0);
        const bool print_up = !flat.turned[std::size_t(o.other)];
        options.chosen.push_back({o.face, o.other, a_above == print_up ? 1 : -1});
        ++overlaps;
      }
      if (overlaps == 0) continue;
      const Layers layers = layer_orders(sheet, flat, options);
      if (!layers.possible) continue;
      state.sheet.creases = sheet.creases;
      state.order = layers.order;
      settle_folds(state, flat);
      return k;
    }
  }
  return -1;
}

void turn_layers(FoldState& state, const FoldStep& step, const std::string& where) {
  Sheet& sheet = state.sheet;
  const CreaseCut cut = straight_cut(step.from, step.to, tolerance);
  const int before = sheet.faces();
  const auto creases = insert_crease(sheet, sheet.folded, cut, Crease::flat);
  split_orders(state, before);
  auto moving = moving_faces(sheet, creases, cut, where);
  if (step.layers != 0) {
    const auto flap = flaps_of(sheet, moving, creases);
    int chosen = outermost_flap(sheet, state.order, flap, step.layers);
    if (chosen < 0 && state.flat) chosen = freed_flap(state, flap, step.layers);
    if (chosen < 0) {
      throw Error(where + ": flaps there lie between each other; none is outermost");
    }
    for (std::size_t f = 0; f < moving.size(); ++f) moving[f] = flap[f] == chosen;
  }
  const double angle = step.degrees * std::numbers::pi / 180.0;
  const Vector3d from(step.from.x(), step.from.y(), 0.0), to(step.to.x(), step.to.y(), 0.0);
  // What lies to the left of the line rises for positive angles.
  const Eigen::AngleAxisd turn(angle, (to - from).normalized());
  std::vector<bool> moves(sheet.folded.size(), false);
  for (int f = 0; f < sheet.faces(); ++f) {
    if (!moving[std::size_t(f)]) continue;
    for (const int v : sheet.corners_of(f)) moves[std::size_t(v)] = true;
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (moves[v]) sheet.folded[v] = from + turn * (sheet.folded[v] - from);
  }
  const auto angles = edge_angles(sheet, sheet.folded);
  for (const int e : creases) {
    const double now = angles[std::size_t(e)];
    sheet.fold_angles[std::size_t(e)] = now;
    sheet.creases[std::size_t(e)] = std::abs(now) < 1e-9 ? Crease::flat
                                    : now > 0.0          ? Crease::valley
                                                         : Crease::mountain;
  }
  state.flat = false;
}

void squash(FoldState& state, const FoldStep& step) {
  for (Vector3d& p : state.sheet.folded) p.z() *= step.share;
  BarNetwork network = rigid_network(state.sheet, 0.0);
  state.sheet.folded = relax(network, std::move(state.sheet.folded)).places;
  state.sheet.fold_angles = edge_angles(state.sheet, state.sheet.folded);
  state.flat = false;
}

void turn_over(FoldState& state, const FoldStep& step) {
  for (Vector3d& p : state.sheet.folded) p = {2.0 * step.from.x() - p.x(), p.y(), -p.z()};
}

// The faces that hold places of the flat sheet.
std::vector<int> faces_at(const Sheet& sheet, const std::vector<Vector2d>& places,
                          const std::string& where) {
  std::vector<int> faces;
  for (const Vector2d& place : places) {
    faces.push_back(face_at(sheet, place));
    if (faces.back() < 0) throw Error(where + ": a place lies beside the paper");
  }
  return faces;
}

void score(FoldState& state, const FoldStep& step, const std::string& where) {
  const FoldStroke& stroke = step.stroke;
  std::vector<bool> chosen;
  if (!step.faces.empty()) chosen.assign(std::size_t(state.sheet.faces()), false);
  for (const int face : faces_at(state.sheet, step.faces, where)) chosen[std::size_t(face)] = true;
  const int before = state.sheet.faces();
  const CreaseCut cut =
      drawn_cut({stroke.eye, stroke.from - stroke.eye}, {stroke.eye, stroke.to - stroke.eye});
  const auto creases = insert_crease(state.sheet, state.sheet.folded, cut, Crease::flat, chosen);
  if (creases.empty()) throw Error(where + ": the line crosses no face from side to side");
  split_orders(state, before);
}

void swing_face(FoldState& state, const FoldStep& step, const std::string& where) {
  Swing swing;
  swing.face = faces_at(state.sheet, {step.from}, where)[0];
  double nearest = 1e300;
  for (const int h : state.sheet.halves_of(swing.face)) {
    const Vector2d &a = state.sheet.flat[std::size_t(state.sheet.origin(h))],
                   &b = state.sheet.flat[std::size_t(state.sheet.target(h))];
    const double share = std::clamp((step.to - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    const double off = (a + share * (b - a) - step.to).norm();
    if (off >= nearest) continue;
    nearest = off;
    swing.axis = h / 2;
  }
  swing.angle = step.degrees * std::numbers::pi / 180.0;
  swing.all = step.layers == 0;
  swing.with = faces_at(state.sheet, step.faces, where);
  swing.pinned = faces_at(state.sheet, step.pins, where);
  if (step.hasty) {
    swing.most_steps = 2;
    swing.strain = 1e-3;
  }
  state.sheet = swung(std::move(state.sheet), swing, where);
  state.flat = false;
}

}  // namespace

FoldState folded_on(FoldState state, const FoldStep& step, const std::string& where) {
  const bool draws = step.action == FoldAction::crease || step.action == FoldAction::fold;
  if (!draws && !state.waiting.empty()) {
    draw(state.sheet, state.waiting, where);
    state.waiting.clear();
  }
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
