#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"
#include "core/random.h"
#include "mechanics/wear.h"

namespace hada {

struct KnitPullArguments {
  std::optional<std::filesystem::path> material;  // absent: the paper's, spacings of 1 mm
  std::filesystem::path out = "pulled";
  int courses = 10;
  int wales = 10;
  std::vector<double> stretches = {1.5};
  std::string along = "wale";
  std::string clamp = "uniform";
  bool as_the_paper = false;  // by its steps instead of Newton's
  double noise = 0.0;         // of the crossings written, over the distance of wales
  Seed seed = 1;
  std::optional<double> photograph_pitch;  // mm: made photographs are written too
};

/// Pulls a flat knit and writes where its crossings come to rest, with a picture.
void knit_pull_command(const KnitPullArguments& arguments, const Terminal& terminal);

struct KnitWearArguments {
  std::optional<std::filesystem::path> body;  // absent: the leg that comes with the program
  std::optional<std::filesystem::path> material;
  std::filesystem::path out = "worn";
  WearOptions options;
  std::string axis = "y";
  std::string shell = "tube";
  double yarn_radius_mm = 0.0;           // 0: a tenth of the distance of wales
  std::optional<double> nylon_N_per_mm;  // k: pressures are then in kPa
  double turn_deg = 0.0;                 // of the pictures
  int picture_rows = 720;
  bool loops = false;  // write the yarn as loops too
};

/// Draws a knit over a body and writes its yarns, its maps and pictures of them.
void knit_wear_command(const KnitWearArguments& arguments, const Terminal& terminal);

struct KnitStiffnessArguments {
  std::filesystem::path crossings;
  std::filesystem::path out = "stiffness.json";
  bool lengths_unknown = false;  // at rest: found too
  std::optional<double> load_N;  // on the clamps in the last state
};

/// Finds stiffness ratio and yarn coefficient from crossings seen at known stretches.
void knit_stiffness_command(const KnitStiffnessArguments& arguments, const Terminal& terminal);

}  // namespace hada
