#include "sheet/turn_layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "sheet/contact.h"
#include "sheet/crease.h"
#include "sheet/flaps.h"
#include "sheet/folded_flat.h"
#include "sheet/kept_order.h"
#include "sheet/layers.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double tolerance = 1e-9;

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

}  // namespace

void turn_layers(FoldState& state, const FoldStep& step, const std::string& where) {
  Sheet& sheet = state.sheet;
  const CreaseCut cut = straight_cut(step.from, step.to, tolerance);
  const int before = sheet.faces();
  const auto creases = insert_crease(sheet, sheet.folded, cut, Crease::flat);
  state.order = split_orders(sheet, state.order, before, creases);
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
  // What lies to the left of the line rises for positive angles.
  const double angle = step.degrees * std::numbers::pi / 180.0;
  const Vector3d from(step.from.x(), step.from.y(), 0.0), to(step.to.x(), step.to.y(), 0.0);
  const Reached reached =
      turn_faces(sheet, state.order, moving, from, (to - from).normalized(), angle);
  if (reached.met) {
    state.contact = {(*reached.met)[0], (*reached.met)[1], reached.share * step.degrees};
  }
  const auto angles = edge_angles(sheet, sheet.folded);
  for (const int e : creases) {
    const double now = angles[std::size_t(e)];
    sheet.fold_angles[std::size_t(e)] = now;
    sheet.creases[std::size_t(e)] = std::abs(now) < 1e-9 ? Crease::flat
                                    : now > 0.0          ? Crease::valley
                                                         : Crease::mountain;
  }
  settle_moved(state, reached.shortly_before);
}

}  // namespace hada
