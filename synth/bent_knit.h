#pragma once

#include <vector>

#include "core/extent.h"
#include "mechanics/knit_net.h"
#include "synth/knit_loops.h"

namespace hada {

/// A flat piece of knit that lies as its crossings say, course after course.
struct BentKnit {
  int courses = 0;
  int wales = 0;
  Places places;

  /// The place of a crossing; beyond a border the knit goes on as it does on this side.
  Eigen::Vector2d at(int wale, int course) const;
  /// Straight between crossings, as springs are.
  Eigen::Vector2d straight(double wale, double course) const;
  /// Smooth over crossings: cubics of Catmull and Rom (1974).
  Eigen::Vector2d smooth(double wale, double course) const;
};

/// How a yarn runs from one crossing to the next.
using BetweenCrossings = Eigen::Vector2d (BentKnit::*)(double wale, double course) const;

/// The yarn of every loop of `bent`, in pixels of `extent`; `YarnPoint::course` is the number of
/// its crossing.
///
/// shift  of each loop, in the unit of `extent`; empty: none
/// throws Error if places are not as many as courses and wales say, or more than 30000
std::vector<YarnPoint> bent_loops(const Knit<>& knit, const BentKnit& bent, const Extent& extent,
                                  BetweenCrossings between,
                                  const std::vector<Eigen::Vector2d>& shift = {});

}  // namespace hada
