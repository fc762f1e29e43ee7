#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/knit_pull.h"

namespace hada {

/// Where the crossings of a knit were seen while it was pulled to a known stretch.
struct KnitState {
  KnitPull pull = KnitPull::wale;
  double stretch = 1.0;
  Places places;  // of all crossings, as `KnitNet` counts them, in the frame of `pulled`; one that
                  // was not seen is not finite
};

struct KnitStiffnessOptions {
  bool lengths_known = true;          // at rest; false: they are found too, from those of the net
  bool frame_known = true;            // false: places are seen from somewhere, up to shift, turn
                                      // and scale in each state; those that are held tell it
  std::optional<double> load_N = {};  // on the clamps in the last state
};

/// A number and its standard deviation.
struct Found {
  double value = 0.0;
  double sigma = 0.0;
};

struct KnitStiffness {
  Found ratio;                          // k of support yarn over that of nylon
  Found continuity;                     // c, the yarn coefficient
  Found wale_mm, course_mm;             // of springs at rest; sigma 0 if they were known
  std::optional<Found> nylon_N_per_mm;  // k of nylon, if a load was given
  double noise_mm = 0.0;                // of a crossing, each way
  double log_ratio_sigma = 0.0;         // intervals of the ratio are even in its logarithm
  int starts = 0, agreeing = 0;
  std::vector<std::string> remarks;
};

/// Stiffness ratio and yarn coefficient of a knit from crossings at known stretches, by least
/// squares over all free crossings, which were located with equal noise.
///
/// The model is the rest under both forces; its derivatives come from the implicit function: where
/// F(x, p) = 0 stays so, J dx/dp = -dF/dp. Sigma is from the information of the fit and the noise
/// that is left.
///
/// What the shape can tell hangs on the clamps, and `remarks` say what it did not. All stiffnesses
/// times a factor make the same shape: k itself is only known from a load.
///
/// net     courses, wales, lengths at rest and continuity; stiffness and pins are not read
/// repeat  of the courses, upward: 0 nylon, else support
/// throws  Error without a state, without a course of each yarn, if a state has other places than
///         the net, if the knit of a state does not come to rest, or if a load is given for a state
///         that pulls at no clamp
KnitStiffness knit_stiffness(const KnitNet& net, const std::vector<int>& repeat, KnitClamp clamp,
                             const std::vector<KnitState>& states,
                             const KnitStiffnessOptions& options = {});

/// The least standard deviations that any unbiased estimate can have (Cramer and Rao); huge where
/// nothing is known.
struct StiffnessBounds {
  double log_ratio = 0.0;
  double continuity = 0.0;
  int rank = 0;  // how many of the two, or of mixtures of them, move any crossing at all
};

/// For crossings located to `noise_mm`.
StiffnessBounds stiffness_bounds(const KnitNet& net, const std::vector<int>& repeat,
                                 KnitClamp clamp, const std::vector<KnitState>& states,
                                 double ratio, double noise_mm);

}  // namespace hada
