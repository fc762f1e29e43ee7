#pragma once

#include <string>

#include "sheet/fold_log.h"
#include "sheet/swing.h"

namespace hada {

/// A step that swings a face, on its way: a hand turns it further with each move.
class HeldSwing {
 public:
  /// step    a `swing`; its degrees say nothing here
  /// hasty   strains up to 1e-3 will do, and orders of layers are settled where faces meet alone:
  ///         the hand waits for every move
  /// throws  Error with `where` if the step names no paper, no crease of it or too many pins
  HeldSwing(FoldState state, const FoldStep& step, bool hasty, const std::string& where);

  /// Turns it by degrees, as far as it goes.
  void further(double degrees);

  const FoldState& state() const { return state_; }
  /// By how much it is turned, degrees.
  double degrees() const;
  /// Whether what the face hangs on could not follow.
  bool stuck() const { return swinging_.now().stuck; }

 private:
  FoldState state_;
  std::vector<FaceOrder> order_;  // at the start
  bool hasty_;
  Swinging swinging_;
};

}  // namespace hada
