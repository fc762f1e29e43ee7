#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hada {

/// How fast facet springs move: faces times steps in a second, one thread.
struct SpringSpeed {
  std::string name;
  int faces = 0;
  double faces_steps_per_second = 0.0;
  int substeps = 1;
};
std::vector<SpringSpeed> spring_speeds();

/// A folded sheet whose vertices were moved at random, made rigid again.
struct ExactScore {
  int faces = 0;
  double strain = 0.0;
  double planarity = 0.0;
  double milliseconds = 0.0;
};
std::vector<ExactScore> exact_scores();

/// The largest difference of a Miura sheet's fold angles, driven by one crease, from
/// tan(minor / 2) = cos(sector) tan(major / 2); degrees, over folds from 10 to 170.
double miura_error_deg();

/// Sheets as another simulator drove them: the largest distance of a vertex after the best
/// movement, share of the sheet.
struct DrivenScore {
  std::string name;
  int percent = 0;
  double error = 0.0;
};
std::vector<DrivenScore> driven_scores(const std::filesystem::path& data);

}  // namespace hada
