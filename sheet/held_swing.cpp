#include "sheet/held_swing.h"

#include <numbers>
#include <utility>

#include "sheet/folded_flat.h"
#include "sheet/places.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

int nearest_side(const Sheet& sheet, int face, const Eigen::Vector2d& place) {
  int nearest = -1;
  double least = 1e300;
  for (const int h : sheet.halves_of(face)) {
    const double off = distance_to(sheet, h / 2, place);
    if (off >= least) continue;
    least = off;
    nearest = h / 2;
  }
  return nearest;
}

Swing swing_of(const Sheet& sheet, const FoldStep& step, bool hasty, const std::string& where) {
  Swing swing;
  swing.face = faces_at(sheet, {step.from}, where)[0];
  swing.axis = nearest_side(sheet, swing.face, step.to);
  swing.all = step.layers == 0;
  swing.with = faces_at(sheet, step.faces, where);
  swing.pinned = faces_at(sheet, step.pins, where);
  if (hasty) {
    swing.most_steps = 2;
    swing.strain = 1e-3;
  }
  return swing;
}

}  // namespace

HeldSwing::HeldSwing(FoldState state, const FoldStep& step, bool hasty, const std::string& where)
    : state_(std::move(state)),
      order_(state_.order),
      hasty_(hasty),
      swinging_(state_.sheet, swing_of(state_.sheet, step, hasty, where), state_.order, where) {}

void HeldSwing::further(double degrees) {
  const double before = swinging_.now().angle;
  swinging_.further(degrees * degree);
  const Swung& now = swinging_.now();
  state_.sheet = now.sheet;
  state_.contact.reset();
  if (now.met) state_.contact = {(*now.met)[0], (*now.met)[1], (now.angle - before) / degree};
  state_.order = order_;
  // Between start and contact no face comes to lie on another.
  if (hasty_ && !now.met) {
    state_.flat = false;
  } else {
    settle_moved(state_, now.shortly_before);
  }
}

double HeldSwing::degrees() const {
  return swinging_.now().angle / degree;
}

}  // namespace hada
