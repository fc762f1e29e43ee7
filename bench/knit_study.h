#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fit/knit_stiffness.h"

namespace hada {

/// The paper's patch of 10 x 10, pulled uniformly along the wales to 1.5.
struct PatchStudy {
  int steps = 0;            // of the paper's motion until no point moves by 1e-3 of the pitch
  double rest_apart = 0.0;  // largest distance of Newton's rest from the long motion, pitches,
                            // over both pulls and both clamps
};
PatchStudy study_patch();

/// Seconds that a net of `count` x `count` takes to rest, uniformly pulled to 1.5: the slower pull.
double seconds_to_rest(int count);

struct WearStudy {
  double seconds = 0.0;  // of drawing, sliding and the repair
  int steps = 0;
  bool settled = false;
  int cut = 0;          // straight yarns that were inside the body
  int penetrating = 0;  // after the repair, deeper than 1e-6 mm
};
/// A tube of `count` x `count` stitches on the shipped leg.
WearStudy study_wear(int count);
/// The same of a stocking with heel and toe, on a leg that has a foot.
WearStudy study_stocking(int count);

/// 16 x 16, three-point clamps along the wales, stretches 1.2 and 1.5, ratio 10, c 0.2, 2 % noise.
struct StiffnessStudy {
  double ratio_bound = 0.0, continuity_bound = 0.0;    // Cramer and Rao
  double ratio_spread = 0.0, continuity_spread = 0.0;  // root mean square errors over seeds
  double coverage = 0.0;                               // of 95 % intervals, both numbers
  double seconds_median = 0.0;
};
StiffnessStudy study_stiffness(int seeds);

/// What the same knit and noise tell at best for a pull and a clamp; `log_ratio` at the ratio 10.
StiffnessBounds clamp_bounds(KnitPull pull, KnitClamp clamp);

/// Largest relative errors of spacings over made pictures of knits of random shape.
struct LatticeStudy {
  double wale = 0.0, course = 0.0;
  double wale_median = 0.0, course_median = 0.0;
};
LatticeStudy study_lattice(int pictures);

/// Errors against the truth beside the pictures of an independent renderer.
struct RenderedKnit {
  std::string name;
  double wale = 0.0, course = 0.0, radius = 0.0, gradient = 0.0;  // relative
  double rotation_deg = 0.0;
  bool repeat = false;
};
std::vector<RenderedKnit> score_rendered_knits(const std::filesystem::path& folder);

/// Wales and courses counted along the picture's width of hand knit.
std::array<double, 2> count_hand_knit(const std::filesystem::path& picture);

/// Distance of the nearest spectral peaks from (32, 64) and (64, 0), the larger one, in cycles over
/// the picture.
double jersey_peak_error(const std::filesystem::path& picture);

}  // namespace hada
