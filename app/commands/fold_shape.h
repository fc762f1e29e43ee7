#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"

namespace hada {

struct FoldSimulateArguments {
  std::filesystem::path input;
  std::filesystem::path out = "simulated.fold";
  double percent = 100.0;
  std::vector<std::string> held;  // "12=90": crease 12 at 90 degrees
  bool elastic = false;
  int frames = 1;
};

/// Drives the creases of a pattern and writes the shape in space that it takes.
void fold_simulate_command(const FoldSimulateArguments& arguments, const Terminal& terminal);

struct FoldRelaxArguments {
  std::filesystem::path input;
  std::filesystem::path out = "relaxed.fold";
  std::string solver = "exact";
  std::vector<int> pinned;  // vertices
  int most_steps = 20000;
  double squash = 1.0;  // of the height, before
};

/// Makes the faces of a folded form stiff again: by the paper's springs or exactly.
void fold_relax_command(const FoldRelaxArguments& arguments, const Terminal& terminal);

struct FoldReplayArguments {
  std::filesystem::path input;
  std::filesystem::path out = "replayed";
  int steps = -1;       // how many of the log; < 0: all
  bool frames = false;  // a picture of every step, and its state in the FOLD file
  double roll_deg = 0.0;
  double turn_deg = 0.0;
  double tilt_deg = 0.0;
  std::optional<double> thickness;
};

/// Repeats a recorded sequence of folds and writes the model, with pictures.
void fold_replay_command(const FoldReplayArguments& arguments, const Terminal& terminal);

struct FoldMeasureArguments {
  std::filesystem::path input;
  std::optional<double> pitch_mm;
  std::optional<std::filesystem::path> lights;  // of a folder of pictures
  double smallest_deg = 1.0;
  std::filesystem::path out = "creases.fold";
};

/// Finds the creases of a re-opened sheet and how far each is folded: on a surface, or in pictures
/// of it, which then correct their lights too.
void fold_measure_command(const FoldMeasureArguments& arguments, const Terminal& terminal);

}  // namespace hada
