#include "fit/grain_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/parallel.h"
#include "core/random.h"
#include "fit/grain_rotation.h"
#include "fit/grain_turn.h"
#include "fit/normal_scores.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr float dither = 0.01f;  // deviation of the noise below which no spectrum is believed
constexpr double rotation_sigma = 3.0 * degree;
constexpr int fewest_pixels = 64;      // of a turned picture
constexpr std::size_t near_ones = 12;  // sequences that are looked at again at another scale
constexpr double worth_turning = 3.0;  // nats: a picture that is not surely turned is not
constexpr double most_sigmas = 5.0;
constexpr int rounds = 3;  // of turning, and guessing with the grain level

/// The largest number up to `n` without prime factors beyond 5: its transform is fast.
int easy_length(int n) {
  for (;; --n) {
    int rest = n;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return n;
  }
}

Grid<float> middle(const Grid<float>& picture, int rows, int cols) {
  return crop(picture, (picture.rows() - rows) / 2, (picture.cols() - cols) / 2, rows, cols);
}

Grid<float> dithered(Grid<float> scores) {
  constexpr Seed seed = 0x68616461;
  for_each_index(scores.rows(), [&](int row) {
    for (int col = 0; col < scores.cols(); ++col)
      scores(row, col) += dither * float(gaussian(seed, row, col));
  });
  return scores;
}

/// Leaves out what turning has weakened.
void keep_band(GrainSpectrum& spectrum) {
  for (int r = 0; r < spectrum.y.cells(); ++r) {
    for (int c = 0; c < spectrum.x.cells(); ++c) {
      if (spectrum.x.edges[std::size_t(c + 1)] > turned_band * spectrum.x.length ||
          spectrum.y.edges[std::size_t(r + 1)] > turned_band * spectrum.y.length)
        spectrum.count(r, c) = 0.0;
    }
  }
}

/// The spectrum of scores whose rows run at `angle_rad`.
GrainSpectrum turned_spectrum(const Grid<float>& scores, double angle_rad) {
  const auto level = angle_rad == 0.0 ? scores : turned_back(scores, angle_rad);
  auto spectrum =
      grain_spectrum(dithered(middle(level, easy_length(level.rows()), easy_length(level.cols()))));
  if (angle_rad != 0.0) keep_band(spectrum);
  return spectrum;
}

/// Logarithm of the Whittle likelihood, per nat, up to a constant of the number of ordinates.
double log_likelihood(const GrainSpectrum& spectrum, const GrainFit& fit) {
  double logs = 0.0;
  for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
    if (spectrum.count[k] > 0.0) logs += spectrum.count[k] * (std::log(spectrum.power[k]) + 1.0);
  }
  return -(fit.cost + logs);
}

/// The angle of the rows that explains the scores best, 0 if that is not worth its own prior.
double rotation_of(const Grid<float>& scores, const SequenceSearchOptions& options) {
  const Grid<float> seen = middle(scores, easy_length(scores.rows()), easy_length(scores.cols()));
  const GrainRotation rotation(dithered(seen));
  GrainAngle best;
  double start = mirror_axis(seen);
  for (int round = 0; round < rounds; ++round) {
    const auto level = turned_back(scores, start);
    if (level.rows() < fewest_pixels || level.cols() < fewest_pixels) return 0.0;
    const auto guesses = first_guesses(turned_spectrum(scores, start), options);
    best = likeliest_angle(rotation, guesses.front(), start);
    if (std::abs(best.angle_rad - start) < 2.0 * best.sigma_rad) break;
    start = best.angle_rad;
  }
  const double off = best.angle_rad / rotation_sigma;
  const double worth = best.gain - 0.5 * off * off - std::log(rotation_sigma / best.sigma_rad);
  return worth > worth_turning && std::abs(off) < most_sigmas ? best.angle_rad : 0.0;
}

struct Tone {
  Scores scores;
  GrainSpectrum spectrum;
  std::vector<SequenceCandidate> guesses;
  double likelihood = 0.0;  // of the picture, in nats, up to a constant
};

Tone explained(Scores scores, double rotation_rad, const SequenceSearchOptions& options) {
  Tone tone;
  tone.spectrum = turned_spectrum(scores.values, rotation_rad);
  tone.guesses = first_guesses(tone.spectrum, options);
  double ordinates = 0.0;
  for (const double count : tone.spectrum.count) ordinates += count;
  // Two pixels for an independent ordinate, the Jacobian of the curve for every pixel.
  tone.likelihood =
      log_likelihood(tone.spectrum, tone.guesses.front().fit) + 2.0 * ordinates * scores.log_slope;
  tone.scores = std::move(scores);
  return tone;
}

Tone best_tone(const Grid<float>& grey, double rotation_rad, const SequenceSearchOptions& options) {
  Tone curved = explained(normal_scores(grey), rotation_rad, options);
  Tone linear = explained(standard_scores(grey), rotation_rad, options);
  return linear.likelihood > curved.likelihood ? linear : curved;
}

}  // namespace

SeenGrain seen_grain(const Grid<float>& grey, const SequenceSearchOptions& options, bool turned) {
  SequenceSearchOptions placed = options, scaled = options;
  placed.scale = GrainScale::one;
  scaled.scale = GrainScale::about_one;
  Tone tone = best_tone(grey, 0.0, placed);
  SeenGrain seen;
  if (turned) seen.rotation_rad = rotation_of(tone.scores.values, scaled);
  if (seen.rotation_rad != 0.0) tone = best_tone(grey, seen.rotation_rad, placed);
  seen.candidates = likely_sequences(std::move(tone.guesses), tone.spectrum, placed);
  if (turned) {
    // What comes near at one pixel a place is where the search at about one begins.
    auto starts = refitted(seen.candidates, near_ones, tone.spectrum, scaled);
    const auto guesses = first_guesses(tone.spectrum, scaled);
    starts.insert(starts.end(), guesses.begin(), guesses.end());
    const auto others = likely_sequences(std::move(starts), tone.spectrum, scaled);
    seen.candidates.insert(seen.candidates.end(), others.begin(), others.end());
  }
  seen.spectrum = std::move(tone.spectrum);
  return seen;
}

}  // namespace hada
