#pragma once

#include <string>
#include <vector>

namespace hada {

/// A log of folds that comes with the program, replayed twice.
struct RecordedFold {
  std::string title;
  int steps = 0;
  int faces = 0;
  bool same = false;    // both replays, to the bit
  int piercing = 0;     // pairs of faces that pass through each other, over all steps
  int flat_states = 0;  // and of those, whose layers lie as paper can
  int ordered_states = 0;
  int contacts = 0;  // steps that ended early
};

/// All logs of data_synthetic/folds, by name.
std::vector<RecordedFold> recorded_folds();

}  // namespace hada
