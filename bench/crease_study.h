#pragma once

namespace hada {

/// Creases of virtual sheets, found in pictures of them.
struct CreaseStudy {
  int creases = 0;
  int found = 0;
  double rms_deg = 0.0;  // of the fold angles
  double worst_deg = 0.0;
  double coverage90 = 0.0;   // share of 90 % intervals that hold the truth
  double line_rms_px = 0.0;  // of the lines' ends, across them
};

struct CreaseStudyOptions {
  int sheets = 6;
  int lights = 12;
  double roughness_deg = 3.0;    // of the paper, each slope
  double light_error_deg = 1.0;  // of the lights that the reconstruction believes
  bool from_pictures = true;     // the pictures correct their lights; else the surface alone
  double fold_low_deg = 4.0;
  double fold_high_deg = 35.0;
};

/// Sheets of three panels with two creases each, photographed twice as fine as they are seen.
CreaseStudy study_creases(const CreaseStudyOptions& options = {});

}  // namespace hada
