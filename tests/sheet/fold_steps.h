#pragma once

#include "sheet/fold_log.h"

namespace hada {

/// A step along a line of the flat sheet.
inline FoldStep line(FoldAction action, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                     double degrees = 180.0) {
  FoldStep step;
  step.action = action;
  step.from = from;
  step.to = to;
  step.degrees = degrees;
  return step;
}

inline FoldStep through(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return line(FoldAction::through, from, to);
}

}  // namespace hada
