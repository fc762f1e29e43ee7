#pragma once

#include <string>
#include <vector>

#include "core/random.h"

namespace hada {

/// The eight pictures of the paper: their sequences, and the seed where it is not 0.
struct PaperGrain {
  std::string sequence;
  Seed seed;
};
std::vector<PaperGrain> paper_grains();

/// What pictures are of: grey values without levels; as a block is made, 70 grey values in steps of
/// 5; or what a camera makes of these, blur 0.7 px, noise 10 %, a tone of its own, 8 bits.
enum class GrainPicture { clean, made, photograph };

struct ForgedStudyOptions {
  int pictures = 24;
  int rows = 512;
  int cols = 1024;
  int folds = 6;
  bool length_known = true;  // all sequences of that length are the candidates
  bool turned = false;  // by up to 4 degrees, scaled and stretched; otherwise the view is known
  GrainPicture picture = GrainPicture::photograph;
};

/// How often the folds of pictures from the middle of blocks are named, as shares.
struct ForgedStudy {
  double counts = 0.0;  // number of C and number of R
  double first = 0.0;   // whole sequence
  double among_three = 0.0;
  double kinds = 0.0;
  int unsure = 0;           // sequences that were given a probability between 0.4 and 0.6
  double unsure_right = 0;  // share of them that were right
  double seconds_median = 0.0;
};

ForgedStudy study_forged(const ForgedStudyOptions& options);

/// Rings of the mean periodogram of blocks over the closed form, for one sequence.
struct GrainRings {
  std::string sequence;
  int rings = 0;
  int within_two_sigma = 0;   // 95.4 % are, if the closed form is exact
  int within_sampling = 0;    // within `ring_sampling_sigmas`
  double worst_ratio = 1.0;   // the ratio furthest from 1
  double sigma_median = 0.0;  // of the ratios
};

/// Deviations that are allowed for as the sampling error of a ring.
///
/// Seven sequences with some 28 rings each, of which 95 % are asked to agree: one may stray. If the
/// closed form is exact, all seven pass in 95 % of all studies where a ring strays with a
/// probability of 0.0044 (28 * 27 / 2 * 0.0044^2 * 7 = 0.05): that is so beyond 2.85 deviations.
/// (Within 2, 4.6 % stray: half of all exact sequences would fail.)
constexpr double ring_sampling_sigmas = 2.85;

/// 512 x 1024 pixels from inside blocks, each seen through a taper.
///
/// The statistics of a block repeat every 2^(number of cuts) places, 4096 for twelve cuts, and the
/// closed form is their mean. So the place of the picture goes through a whole period, evenly from
/// seed to seed along the columns and along the rows; what it adds to the scatter is smooth, and
/// the differences between one seed and the next are free of it.
GrainRings grain_rings(const std::string& sequence, int seeds);

/// Median seconds of processor time, of all threads together, for a block of 2048 x 16384, levels
/// included.
double block_processor_seconds(const std::string& sequence, int repeats);

}  // namespace hada
