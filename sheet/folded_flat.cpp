#include "sheet/folded_flat.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "sheet/arrangement.h"
#include "sheet/kept_order.h"
#include "sheet/layers.h"

namespace hada {
using Eigen::Vector2d;

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

std::string blocked_flat(FoldState& state, const std::string& where, int staying,
                         const std::vector<FaceOrder>& known) {
  FlatState flat = flat_state(state.sheet);
  if (flat.gap > 1e-7 * size_of(state.sheet.flat)) {
    throw Error(where + ": the paper would tear; its folds do not close around a vertex");
  }
  keep_in_place(flat, state.sheet, staying);
  LayerOptions options;
  options.count = false;
  options.chosen = known;
  const Layers layers = layer_orders(state.sheet, flat, options);
  if (!layers.possible) return layers.reason;
  state.order = layers.order;
  state.flat = true;
  settle_folds(state, flat);
  return "";
}

void flatten(FoldState& state, const std::string& where, int staying) {
  const std::string reason = blocked_flat(state, where, staying, {});
  if (!reason.empty()) throw Error(where + ": " + reason);
}

void settle_moved(FoldState& state, const std::vector<Eigen::Vector3d>& shortly_before) {
  Sheet& sheet = state.sheet;
  state.order = moved_orders(sheet, state.order, shortly_before);
  shut_as_ordered(sheet, state.order);
  const double level = 1e-7 * size_of(sheet.flat);  // where a turn ends when faces land
  state.flat = std::all_of(sheet.folded.begin(), sheet.folded.end(),
                           [&](const Eigen::Vector3d& p) { return std::abs(p.z()) < level; });
  for (Eigen::Vector3d& p : sheet.folded) {
    if (state.flat) p.z() = 0.0;
  }
}

std::string order_flaw(const FoldState& state) {
  if (!state.flat) return "";
  FlatState flat = flat_state(state.sheet);
  keep_in_place(flat, state.sheet, 0);
  LayerOptions options;
  options.count = false;
  options.chosen = state.order;
  const Layers layers = layer_orders(state.sheet, flat, options);
  if (!layers.possible) return layers.reason;
  const int open = layers.overlapping_pairs - int(state.order.size());
  if (open == 0) return "";
  return std::to_string(open) + " pairs of faces lie on each other and have no order";
}

}  // namespace hada
