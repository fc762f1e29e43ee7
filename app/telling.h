#pragma once

#include <string>
#include <vector>

#include "app/whole_path.h"

/// Results as short sentences: what was done and the numbers that matter, with their sigma. The
/// terminal prints them and the report begins with them.
namespace hada {

/// Which calibration is in force: "8 near lights taken from lights.json, read off 1 sphere
/// (matte)", or as for a calibration.
std::string told(const LitCapture& lit);

/// "8 distant lights read off 2 spheres (matte, chrome), each direction known to 0.12 deg; the
/// spheres disagree by 0.21 deg."
std::string told(const Calibration& calibration);

/// "640 x 480 pixels, height 0.123 mm root mean square, ..."
std::string told(const Reconstruction& reconstruction);

/// One line per parameter group of the fit, then how well the model holds.
std::vector<std::string> told(const MaterialFile& material);

std::string told(const TruthCheck& truth);

/// "0.1234 +- 0.0045", with as many digits as the sigma supports.
std::string with_sigma(double value, double sigma);

/// Root of the mean square of the known direction sigmas, degrees; 0 where the lights were given.
double direction_sigma_deg(const std::vector<Light>& lights);

double mean_deg(const std::vector<double>& radians);

/// "800 x 600"
std::string size_text(const Extent& extent);

}  // namespace hada
