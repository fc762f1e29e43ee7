#include "sheet/fold_log.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "mechanics/bar_network.h"
#include "sheet/arrangement.h"
#include "sheet/crease.h"
#include "sheet/layers.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tolerance = 1e-9;

// A line on the flat sheet that waits for the others: alone it may end inside a face.
struct DrawnLine {
  Vector2d from, to;
  Crease crease;
};

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

// Folds that were left open become mountains or valleys as the layers lie.
void settle_folds(FoldState& state, const FlatState& flat) {
  std::map<std::pair<int, int>, int> order_of;
  for (const FaceOrder& o : state.order) order_of[{o.face, o.other}] = o.order;
  Sheet& sheet = state.sheet;
  for (int e = 0; e < sheet.edges(); ++e) {
    Crease& crease = sheet.creases[std::size_t(e)];
    if (crease == Crease::unassigned) {
      const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
      // The order speaks of the side of the second face's print: a valley lays print on print.
      const auto found = order_of.find({std::min(a, b), std::max(a, b)});
      if (found != order_of.end()) {
        crease = found->second > 0 ? Crease::valley : Crease::mountain;
      }
    }
    const double angle = crease == Crease::valley     ? std::numbers::pi
                         : crease == Crease::mountain ? -std::numbers::pi
                                                      : 0.0;
    sheet.fold_angles[std::size_t(e)] = angle;
  }
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) sheet.folded[v] << flat.vertices[v], 0.0;
}

// The paper as it lies was placed by its first face; a fold must not move what stays.
void keep_in_place(FlatState& flat, const Sheet& sheet, int face) {
  const auto corners = sheet.corners_of(face);
  const std::size_t a = std::size_t(corners[0]), b = std::size_t(corners[1]);
  const Vector2d was_a = sheet.folded[a].head<2>(), was = sheet.folded[b].head<2>() - was_a;
  const Vector2d is_a = flat.vertices[a], is = flat.vertices[b] - is_a;
  Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(std::atan2(was.y(), was.x()) - std::atan2(is.y(), is.x()))
          .toRotationMatrix();
  // Lying over, it is turned about the side that both share.
  const std::size_t c = std::size_t(corners[2]);
  const auto side = [](const Vector2d& u, const Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double was_side = side(was, sheet.folded[c].head<2>() - was_a);
  const double is_side = side(is, flat.vertices[c] - is_a);
  const bool over = was_side * is_side < 0.0;
  if (over) {
    const Vector2d u = was.normalized();
    turn = (2.0 * u * u.transpose() - Eigen::Matrix2d::Identity()) * turn;
    for (std::size_t f = 0; f < flat.turned.size(); ++f) flat.turned[f] = !flat.turned[f];
  }
  for (Vector2d& p : flat.vertices) p = turn * (p - is_a) + was_a;
}

void flatten(FoldState& state, const std::string& where, int staying = 0) {
  FlatState flat = flat_state(state.sheet);
  if (flat.gap > 1e-7 * size_of(state.sheet.flat)) {
    throw Error(where + ": the paper would tear; its folds do not close around a vertex");
  }
  keep_in_place(flat, state.sheet, staying);
  LayerOptions options;
  options.count = false;
  const Layers layers = layer_orders(state.sheet, flat, options);
  if (!layers.possible) throw Error(where + ": " + layers.reason);
  state.order = layers.order;
  state.flat = true;
  settle_folds(state, flat);
}

// Faces that were cut lie over others as the whole did; the parts of one do not overlap.
void split_orders(FoldState& state, int before) {
  const Sheet& sheet = state.sheet;
  if (sheet.faces() == before || !state.flat) return;
  FlatState flat = flat_state(sheet);
  keep_in_place(flat, sheet, 0);
  LayerOptions options;
  options.count = false;
  options.chosen = state.order;
  const Layers layers = layer_orders(sheet, flat, options);
  if (layers.possible) state.order = layers.order;
}

// The faces to the left of creases, as far as paper hangs together without crossing them.
std::vector<bool> moving_faces(const Sheet& sheet, const std::vector<int>& creases,
                               const CreaseCut& cut, const std::string& where) {
  if (creases.empty()) throw Error(where + ": its line crosses no paper from side to side");
  std::vector<bool> moving(std::size_t(sheet.faces()), false),
      barrier(std::size_t(sheet.edges()), false);
  for (const int e : creases) barrier[std::size_t(e)] = true;
  const auto is_left = [&](int face) {
    double sum = 0.0;
    for (const int v : sheet.corners_of(face)) sum += cut.side(sheet.folded[std::size_t(v)]);
    return sum > 0.0;
  };
  std::vector<int> open;
  for (const int e : creases) {
    for (const int face : {sheet.half(2 * e).face, sheet.half(2 * e + 1).face}) {
      if (face < 0 || !is_left(face) || moving[std::size_t(face)]) continue;
      moving[std::size_t(face)] = true;
      open.push_back(face);
    }
  }
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (const int h : sheet.halves_of(face)) {
      const int other = sheet.half(h ^ 1).face;
      if (other < 0 || barrier[std::size_t(h / 2)] || moving[std::size_t(other)]) continue;
      moving[std::size_t(other)] = true;
      open.push_back(other);
    }
  }
  for (const int e : creases) {
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (a < 0 || b < 0 || moving[std::size_t(a)] != moving[std::size_t(b)]) continue;
    throw Error(where + ": the line does not part the paper; what moves hangs on what stays");
  }
  return moving;
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

// Of the flaps that the line parts off, the one that lies above (or below) all others.
std::vector<bool> outermost_flap(const FoldState& state, const std::vector<bool>& moving,
                                 const std::vector<int>& creases, int side) {
  const Sheet& sheet = state.sheet;
  std::vector<bool> barrier(std::size_t(sheet.edges()), false);
  for (const int e : creases) barrier[std::size_t(e)] = true;
  std::vector<int> flap(moving.size(), -1);
  int flaps = 0;
  for (std::size_t first = 0; first < moving.size(); ++first) {
    if (!moving[first] || flap[first] >= 0) continue;
    std::vector<int> open{int(first)};
    flap[first] = flaps;
    while (!open.empty()) {
      const int face = open.back();
      open.pop_back();
      for (const int h : sheet.halves_of(face)) {
        const int other = sheet.half(h ^ 1).face;
        if (other < 0 || barrier[std::size_t(h / 2)] || !moving[std::size_t(other)]) continue;
        if (flap[std::size_t(other)] >= 0) continue;
        flap[std::size_t(other)] = flaps;
        open.push_back(other);
      }
    }
    ++flaps;
  }
  // A flap is outermost if no face of another lies outside one of its own.
  std::vector<bool> covered(std::size_t(flaps), false);
  for (const FaceOrder& o : state.order) {
    const int a = flap[std::size_t(o.face)], b = flap[std::size_t(o.other)];
    if (a < 0 || b < 0 || a == b) continue;
    const auto corners = sheet.corners_of(o.other);
    const Vector3d& p = sheet.folded[std::size_t(corners[0])];
    const Vector3d normal = (sheet.folded[std::size_t(corners[1])] - p)
                                .cross(sheet.folded[std::size_t(corners[2])] - p);
    const bool a_above = (o.order > 0) == (normal.z() > 0.0);
    covered[std::size_t(a_above == (side > 0) ? b : a)] = true;
  }
  const int chosen = int(std::find(covered.begin(), covered.end(), false) - covered.begin());
  std::vector<bool> result(moving.size(), false);
  for (std::size_t f = 0; f < result.size(); ++f) result[f] = flap[f] == chosen;
  return result;
}

void turn_layers(FoldState& state, const FoldStep& step, const std::string& where) {
  Sheet& sheet = state.sheet;
  const CreaseCut cut = straight_cut(step.from, step.to, tolerance);
  const int before = sheet.faces();
  const auto creases = insert_crease(sheet, sheet.folded, cut, Crease::flat);
  split_orders(state, before);
  auto moving = moving_faces(sheet, creases, cut, where);
  if (step.layers != 0) moving = outermost_flap(state, moving, creases, step.layers);
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

}  // namespace

std::vector<FoldState> replayed(const FoldLog& log) {
  FoldState state;
  state.sheet = square_sheet(log.side);
  std::vector<FoldState> states{state};
  std::vector<DrawnLine> drawn;
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    const FoldStep& step = log.steps[i];
    const std::string where = log.title + ": step " + std::to_string(i + 1);
    const bool draws = step.action == FoldAction::crease || step.action == FoldAction::fold;
    if (!draws && !drawn.empty()) {
      draw(state.sheet, drawn, where);
      drawn.clear();
    }
    switch (step.action) {
      case FoldAction::crease:
        drawn.push_back({step.from, step.to, Crease::flat});
        break;
      case FoldAction::fold:
        drawn.push_back({step.from, step.to, step.crease});
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
    }
    states.push_back(state);
  }
  return states;
}

}  // namespace hada
