#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hada {

/// How well a face is predicted from the others.
struct LeftOut {
  std::string face;
  int places = 0;         // where rings of it are seen by the solid of all faces
  double error = 0.0;     // median distance of the predicted lines from them, px
  double width = 0.0;     // the same over the distance of rings
  double coverage = 0.0;  // of the 90 % bands
  bool has_slope = false;
  double slope = 0.0;     // mean slope of the fibres that is seen
  double expected = 0.0;  // and predicted
  double expected_sigma = 0.0;
};

/// Every face of the block in `folder` (see the README beside it) but the first end grain, left out
/// in turn; none if the folder is missing.
std::vector<LeftOut> left_out_faces(const std::filesystem::path& folder);

/// How the solid of a rendered block agrees with its truth.
struct SolidScore {
  double lean = 0.0;      // error, the length of the vector
  double taper = 0.0;     // error
  double line_mm = 0.0;   // median distance of the ring lines of a slanted cut from the true ones
  double coverage = 0.0;  // of their 90 % bands
};

/// folder  of rendered/wood_block; name "softwood_a" or "ringporous_b"
SolidScore score_solid(const std::filesystem::path& folder, const char* name);

}  // namespace hada
