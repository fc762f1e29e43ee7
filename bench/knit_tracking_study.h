#pragma once

namespace hada {

/// Made photographs (three times finer than seen, uneven loops, mottle, noise, eight bits) of a
/// piece of 16 x 16 at rest and pulled along the wales by three-point clamps to 1.2 and 1.5, ratio
/// 10 and c 0.2; shifted and turned. Everything is found from the pictures.
struct TrackingStudy {
  int trials = 0;
  int found = 0;             // trials whose crossings were found
  double off_px = 0.0;       // of a crossing each way, root mean square, up to the frame
  double off_wales = 0.0;    // the same
  double ratio_error = 0.0;  // root mean square over the trials that were found
  double ratio_sigma = 0.0;  // as the fits say, root mean square
  double continuity_error = 0.0;
  double continuity_sigma = 0.0;
  double coverage = 0.0;  // of 95 % intervals, both numbers
  double seconds = 0.0;   // of a fit, the mean
};
TrackingStudy study_tracking(int trials);

}  // namespace hada
