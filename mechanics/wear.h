#pragma once

#include <optional>

#include "mechanics/worn_knit.h"

namespace hada {

struct WearOptions {
  int courses = 150;
  int wales = 150;
  int axis = 1;  // x, y or z: along which the tube is drawn
  // Heights along the axis between which it is drawn; absent: a twentieth of the body from its end.
  std::optional<double> from_mm = {};
  std::optional<double> to_mm = {};
  double girth = 0.7;   // of the tube at rest, over the smallest one of the body there
  double length = 0.6;  // of the tube at rest, over the way between the heights
  double ratio = 10.0;  // k of support yarn over that of nylon
  double continuity = 0.2;
  std::vector<int> repeat = {0, 1};  // of the courses: 0 nylon, 1 support
  double friction = 0.0;             // see `worn`
  int most_steps = 100;
  double tolerance = 1e-3;  // of a step, over the distance of wales, where it ends
};

/// A tube of stitches drawn over a body and let go: it slides until nothing pulls it along.
///
/// The tube begins with even stitches around and along the body, on its surface; both ends are held
/// there as cuffs would. The points then go where the forces along the surface vanish, by
/// Newton steps in the tangent planes and back onto the surface, which is where the paper's sliding
/// ends. Points touch the body throughout; where the knit would rather bridge a hollow, `lifting`
/// counts them.
///
/// friction  Coulomb's coefficient mu. 0: the knit slides freely. Else a point stays where the
///           force along the surface is at most mu times the one onto it, and goes no further than
///           where that becomes so. What it finds is one of many states at rest: that which is
///           reached from the even tube.
/// throws    Error if the options make no tube, or a ray from the middle of the body at some height
///           leaves through no surface
///
/// Source: Sakaguchi and Miyata (2013), section 6.
WornKnit worn(const Body& body, const WearOptions& options = {});

/// throws  Error if the options make no knit
void expect_wearable(const WearOptions& options);

}  // namespace hada
