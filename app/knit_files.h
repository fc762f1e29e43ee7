#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mechanics/knit_pull.h"
#include "synth/knit.h"

namespace hada {

/// Crossings of a flat knit, followed through states of pull: `knit_crossings/1`.
struct KnitCrossings {
  KnitNet net;  // its courses, wales, lengths at rest
  std::vector<int> repeat = {0, 1};
  KnitClamp clamp = KnitClamp::uniform;
  bool frame_known = true;  // places count from the middle of the knit; else from that of a picture
  struct State {
    KnitPull pull = KnitPull::wale;
    double stretch = 1.0;
    Places places_mm;
  };
  std::vector<State> states;
};

/// throws  Error naming the file and the key if it is not such a file, a state does not have a
/// place
///         for each crossing, or there are more than a million
KnitCrossings read_crossings(const std::filesystem::path& path);
std::string crossings_text(const KnitCrossings& crossings);

/// "wale" or "course"; "uniform" or "three-points".
KnitPull pull_named(const std::string& name);
KnitClamp clamp_named(const std::string& name);

/// The knit of a material file.
/// throws  Error if it is of another material
Knit<> read_knit(const std::filesystem::path& path);

/// Which courses of a knit are of support yarn: those whose yarn is not the first; every second one
/// if the knit has one yarn only.
std::vector<int> repeat_of(const Knit<>& knit);

}  // namespace hada
