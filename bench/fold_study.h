#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hada {

/// A crease pattern of the collection against what others found.
struct PatternScore {
  std::string name;
  int faces = 0;
  double geometry_error = 0.0;  // largest, share of the sheet, after the best movement
  std::string states_published;
  std::string states;
  double milliseconds = 0.0;  // flat geometry and all states, median of some runs
};

/// All patterns of `data`/fold/crease_patterns that `states.csv` lists.
std::vector<PatternScore> score_patterns(const std::filesystem::path& data, int runs = 5);

/// A pattern that does not fold flat: why, or empty if it was not rejected.
struct Rejection {
  std::string name;
  std::string reason;
};
std::vector<Rejection> score_unfoldable(const std::filesystem::path& data);

}  // namespace hada
