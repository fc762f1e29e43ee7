#pragma once

#include <filesystem>

namespace hada {

/// How a disc of pine agrees with the rings that another program detected on it.
struct DiscScore {
  double pith_share = 0.0;  // distance of the piths over the radius of the disc
  int rings = 0;            // of the other program, its pith left out
  int found = 0;            // of these: mean distance along the ring below 6 px
  int followed = 0;         // that it saw, and did not draw between its neighbours by a formula
  int followed_found = 0;   // of these
  double radius_px = 0.0;   // median difference of mean radii
  double seconds = 0.0;     // of one core
};

/// folder  of wood/disc
DiscScore score_disc(const std::filesystem::path& folder);

/// Profiles of x-ray density whose first and last year are known.
struct ProfileScore {
  int dated = 0;
  int right = 0;  // ring count within 1 of the years
};

/// folder  of wood/xray_profiles
ProfileScore score_profiles(const std::filesystem::path& folder);

}  // namespace hada
