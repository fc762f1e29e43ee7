#pragma once

#include "mechanics/knit_net.h"

namespace hada {

enum class KnitPull { course, wale };            // along which the knit is pulled
enum class KnitClamp { uniform, three_points };  // whole edges are held, or three points of each

/// A flat knit that is about to be pulled.
struct PulledKnit {
  KnitNet net;  // with what the clamps hold pinned
  Places start;
};

/// `net`, laid flat about the origin (courses along x, wales up y) and stretched evenly to
/// `stretch` times its length at rest along `pull`; two opposite edges are then held where they
/// are.
///
/// throws  Error unless stretch is finite and 1 at least: a knit that is pushed folds out of its
///         plane, and what balances there within it does not last
PulledKnit pulled(KnitNet net, KnitPull pull, KnitClamp clamp, double stretch);

}  // namespace hada
