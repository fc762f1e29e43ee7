#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/surface.h"
#include "synth/wrinkle.h"

namespace hada {

/// One of the seven papers that ship.
struct Paper {
  std::string name;
  Wrinkle<> wrinkle;
};
std::vector<Paper> shipped_papers();

/// A sheet of a paper as no two are alike: every amplitude, length and direction of a component
/// differs (8 %, 8 %, 3 deg), it lies turned, and 0.003 mm of noise is on it. 512 x 512 pixels of
/// 0.25 mm, cut from a field that is larger and sampled twice as finely.
Surface sheet_of(const Paper& paper, double turn_rad, unsigned seed);

struct PaperScore {
  std::string name;
  double named_right = 0.0;       // share of sheets whose most probable kind is the true one
  double mean_probability = 0.0;  // that the true kind was given
};

/// How often `classify` names the paper that a sheet is of.
std::vector<PaperScore> study_papers(int sheets_each);

/// A picture with a column for each paper: its relief above, its spectrum below, all at one scale.
void write_papers_picture(const std::filesystem::path& path);

}  // namespace hada
