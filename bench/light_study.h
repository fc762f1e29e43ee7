#pragma once

namespace hada {

struct LightStudyOptions {
  int seeds = 10;
  bool near = false;    // lamps at 250 to 400 mm instead of far away
  bool chrome = false;  // a chrome sphere alone instead of a matte one
};

/// How far the lights of virtual captures are from the truth, and how often their intervals hold
/// it.
struct LightStudy {
  double median_error_deg = 0.0;
  double coverage90 = 0.0;   // share of tangent components within 1.645 sigma
  double typical_z = 0.0;    // root mean square of error over sigma; 1 is honest
  double position_mm = 0.0;  // median error of the lamps' places, near lamps only
  int components = 0;
};

/// Captures of a waved sheet beside a sphere, lights drawn anew for every seed, rendered four times
/// finer than a pixel with noise and 16 bits.
LightStudy study_lights(const LightStudyOptions& options);

}  // namespace hada
