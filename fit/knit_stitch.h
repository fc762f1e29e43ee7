#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/surface.h"
#include "synth/knit.h"

namespace hada {

/// The mean of all repeats of a picture: one wale wide, one colour repeat high, row 0 at the top.
struct MeanStitch {
  std::vector<Grid<float>> planes;  // linear brightness, a plane for each colour
  Grid<float> weight;               // how many pixels fell into each place
};

/// The picture folded onto one repeat of the lattice of `knit`, `cols` places to a wale.
///
/// knit  its course distance is that of a whole repeat, and its colour_repeat a single entry
MeanStitch mean_stitch(const Surface& surface, const Knit<>& knit, int cols);

/// The yarn that explains a mean stitch.
struct StitchFit {
  Knit<> knit;                // course distance, phases, radius, loop, colours and their repeat
  Eigen::VectorXd sigma;      // of radius (mm), width, reach, depth (mm), and the two phases
  double colour_sigma = 0.0;  // of each colour of a yarn
  double unexplained = 1.0;   // share of the variance of the mean stitch
  bool on_bound = false;
};

/// The loop, the radius and the colours of the yarn in `mean`, if the repeat has `courses` courses.
///
/// For a yarn of every course, brightness is linear in 1, the normal and the depth (any light that
/// does not make shadows); holes are of one brightness. These are solved for, the geometry is
/// searched from a net of starts. Courses of the same colour share an entry of `yarns`, dark ones
/// first.
StitchFit fit_stitch(const MeanStitch& mean, const Knit<>& knit, int courses);

}  // namespace hada
