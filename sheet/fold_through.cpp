#include "sheet/fold_through.h"

#include <algorithm>

#include "core/error.h"
#include "sheet/crease.h"
#include "sheet/flaps.h"
#include "sheet/folded_flat.h"
#include "sheet/kept_order.h"
#include "sheet/places.h"

namespace hada {
namespace {

constexpr double tolerance = 1e-9;

int first_staying(const std::vector<bool>& moving) {
  return int(std::find(moving.begin(), moving.end(), false) - moving.begin());
}

// Folds within what moves may go either way.
void free_folds(Sheet& sheet, const std::vector<bool>& moving) {
  for (int e = 0; e < sheet.edges(); ++e) {
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (a < 0 || b < 0 || !moving[std::size_t(a)] || !moving[std::size_t(b)]) continue;
    Crease& crease = sheet.creases[std::size_t(e)];
    if (is_folded(crease)) crease = Crease::unassigned;
  }
}

// Of the folds that are open, those nearest to places of the flat sheet go the way that is said.
void decide(Sheet& sheet, const std::vector<Eigen::Vector2d>& places, Crease way,
            const std::string& where) {
  for (const Eigen::Vector2d& place : places) {
    double nearest = 1e300;
    int decided = -1;
    for (int e = 0; e < sheet.edges(); ++e) {
      if (sheet.creases[std::size_t(e)] != Crease::unassigned) continue;
      const double off = distance_to(sheet, e, place);
      if (off >= nearest) continue;
      nearest = off;
      decided = e;
    }
    if (decided < 0) throw Error(where + ": no fold is left whose direction could be chosen");
    sheet.creases[std::size_t(decided)] = way;
  }
}

}  // namespace

void fold_through(FoldState& state, const FoldStep& step, const std::string& where) {
  if (!state.flat) throw Error(where + ": the sheet is not flat; flatten it first");
  Sheet& sheet = state.sheet;
  const CreaseCut cut = straight_cut(step.from, step.to, tolerance);
  const int before = sheet.faces();
  const auto creases =
      insert_crease(sheet, sheet.folded, cut, Crease::flat, chosen_faces(sheet, step.faces, where));
  const auto order = split_orders(sheet, state.order, before, creases);
  const auto moving = moving_faces(sheet, creases, cut, where);
  for (const int e : creases) {
    Crease& crease = sheet.creases[std::size_t(e)];
    crease = is_folded(crease) ? Crease::flat : Crease::unassigned;
  }
  // What turns as one keeps its order too: it is told by the printed sides.
  std::vector<FaceOrder> kept;
  for (const FaceOrder& o : order) {
    const bool a = moving[std::size_t(o.face)], b = moving[std::size_t(o.other)];
    if (a == b && (step.stiff || !a)) kept.push_back(o);
  }
  if (!step.stiff) free_folds(sheet, moving);
  decide(sheet, step.mountains, Crease::mountain, where);
  decide(sheet, step.valleys, Crease::valley, where);
  const int staying = first_staying(moving);
  if (blocked_flat(state, where, staying, kept).empty()) return;
  flatten(state, where, staying);
}

}  // namespace hada
