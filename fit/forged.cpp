#include "fit/forged.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/srgb.h"
#include "fit/grey_levels.h"
#include "fit/normal_scores.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 64;
constexpr int most_rows = 2048, most_cols = 4096;  // of a picture; the middle of a larger one
constexpr float dither = 0.01f;     // deviation of the noise below which no spectrum is believed
constexpr double same_class = 0.5;  // nats by which members of a class may be told apart
constexpr double worth_telling = 1e-6;  // probability of a sequence that is listed

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

/// The middle of the picture, as it is stored: 0 to 255.
Grid<float> grey_of(const Surface& surface) {
  Grid<float> grey = surface.albedo.empty() ? surface.height : luminance(surface.albedo);
  if (grey.rows() < fewest_pixels || grey.cols() < fewest_pixels) {
    throw Error(
        fmt::format("forged steel: the picture has {} x {} pixels, at least {} x {} are "
                    "needed to see grain",
                    grey.cols(), grey.rows(), fewest_pixels, fewest_pixels));
  }
  const int rows = easy_length(std::min(grey.rows(), most_rows));
  const int cols = easy_length(std::min(grey.cols(), most_cols));
  grey = crop(grey, (grey.rows() - rows) / 2, (grey.cols() - cols) / 2, rows, cols);
  if (!surface.albedo.empty()) {
    for (float& g : grey) g = 255.0f * srgb_from_linear(std::clamp(g, 0.0f, 1.0f));
  }
  return grey;
}

void add_dither(Grid<float>& scores) {
  constexpr Seed seed = 0x68616461;
  for_each_index(scores.rows(), [&](int row) {
    for (int col = 0; col < scores.cols(); ++col)
      scores(row, col) += dither * float(gaussian(seed, row, col));
  });
}

/// Nats by which a picture made with `a` is expected to speak against `b`.
double told_apart(const std::vector<double>& a, const std::vector<double>& b,
                  const GrainSpectrum& spectrum) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double d = std::log(a[k] / b[k]);
    sum += spectrum.count[k] * (std::exp(d) - 1.0 - d);
  }
  return sum;
}

std::vector<SequenceClass> classes_of(const std::vector<SequenceCandidate>& all,
                                      const GrainSpectrum& spectrum, double scatter) {
  double total = 0.0;
  std::vector<double> weight;
  for (const SequenceCandidate& one : all) {
    weight.push_back(std::exp(all.front().loss(scatter) - one.loss(scatter)));
    total += weight.back();
  }
  std::vector<SequenceClass> classes;
  std::vector<std::vector<double>> expected;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double probability = weight[k] / total;
    if (probability < worth_telling) break;
    std::vector<double> cells;
    expected_cells(all[k].model, all[k].fit.nuisance, spectrum, cells);
    const auto same = [&](const auto& other) {
      return told_apart(cells, other, spectrum) < same_class;
    };
    const auto found = std::find_if(expected.begin(), expected.end(), same);
    if (found == expected.end()) {
      expected.push_back(std::move(cells));
      classes.push_back({{all[k].model.sequence}, probability});
    } else {
      auto& known = classes[std::size_t(found - expected.begin())];
      known.sequences.push_back(all[k].model.sequence);
      known.probability += probability;
    }
  }
  std::stable_sort(classes.begin(), classes.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  return classes;
}

GrainKinds kinds_of(const std::vector<SequenceCandidate>& all, double scatter) {
  GrainKinds kinds;
  double total = 0.0;
  for (const SequenceCandidate& one : all) {
    const double weight = std::exp(all.front().loss(scatter) - one.loss(scatter));
    const auto kind = kind_of(one.model.sequence);
    (kind == "masame" ? kinds.masame : kind == "itame" ? kinds.itame : kinds.mokume) += weight;
    total += weight;
  }
  return {kinds.masame / total, kinds.itame / total, kinds.mokume / total};
}

/// The depth of the etching, from the heights if there are any.
void etched(const Surface& surface, ForgedFit& fit) {
  if (surface.albedo.empty() || !surface.has_height()) {
    fit.sigma.etch_mm = fit.material.etch_mm;
    fit.remarks.push_back("How deep the grain is etched cannot be seen: etch_mm is a guess.");
    return;
  }
  // The slope of the height over the grey value.
  const Grid<float> brightness = luminance(surface.albedo);
  double grey = 0.0, height = 0.0, both = 0.0, squares = 0.0, heights = 0.0, count = 0.0;
  for (std::size_t k = 0; k < brightness.size(); ++k) {
    if (!surface.mask[k]) continue;
    const double g = 255.0 * srgb_from_linear(std::clamp(brightness[k], 0.0f, 1.0f));
    const double h = surface.height[k];
    grey += g;
    height += h;
    both += g * h;
    squares += g * g;
    heights += h * h;
    count += 1.0;
  }
  both -= grey * height / count;
  squares -= grey * grey / count;
  heights -= height * height / count;
  const double slope = squares > 0.0 ? both / squares : 0.0;
  const double unexplained = std::max(heights - slope * both, 0.0);
  fit.material.etch_mm = std::clamp(slope * fit.material.levels, 0.0, 1.0);
  fit.sigma.etch_mm =
      std::hypot(fit.material.levels * std::sqrt(unexplained / std::max(squares * count, 1e-300)),
                 slope * fit.sigma.levels);
}

struct Explained {
  GrainSpectrum spectrum;
  std::vector<SequenceCandidate> candidates;
  double likelihood = 0.0;  // of the picture, in nats, up to a constant
};

Explained guessed(Scores scores, const SequenceSearchOptions& options) {
  add_dither(scores.values);
  Explained e;
  e.spectrum = grain_spectrum(scores.values);
  e.candidates = first_guesses(e.spectrum, options);
  double ordinates = 0.0, logs = 0.0;
  for (std::size_t k = 0; k < e.spectrum.power.size(); ++k) {
    const double n = e.spectrum.count[k];
    if (n == 0.0) continue;
    ordinates += n;
    logs += n * (std::log(e.spectrum.power[k]) + 1.0);
  }
  // Two pixels for an independent ordinate, the Jacobian of the curve for every pixel.
  e.likelihood = -(e.candidates.front().fit.cost + logs) + 2.0 * ordinates * scores.log_slope;
  return e;
}

}  // namespace

std::string_view kind_of(const std::string& sequence) {
  const auto columns = double(std::count(sequence.begin(), sequence.end(), 'C'));
  const double drawn = std::abs(2.0 * columns / double(sequence.size()) - 1.0);
  return drawn > 0.7 ? "masame" : drawn > 0.2 ? "itame" : "mokume";
}

ForgedFit fit_forged(const Surface& surface, const SequenceSearchOptions& options) {
  const Grid<float> grey = grey_of(surface);
  Explained best = guessed(normal_scores(grey), options);
  Explained plain = guessed(standard_scores(grey), options);
  if (plain.likelihood > best.likelihood) best = std::move(plain);
  best.candidates = likely_sequences(std::move(best.candidates), best.spectrum, options);

  ForgedFit fit;
  const SequenceCandidate& first = best.candidates.front();
  fit.nuisance = first.fit.nuisance;
  fit.cost = first.fit.cost;
  fit.runner_up_gap =
      best.candidates.size() > 1 ? best.candidates[1].loss() - first.loss() : HUGE_VAL;
  fit.starts = int(best.candidates.size());
  fit.agreeing = 1;
  const auto cells = std::count_if(best.spectrum.count.begin(), best.spectrum.count.end(),
                                   [](double count) { return count > 0.0; });
  fit.deviance = 2.0 * first.fit.cost / double(cells);
  const double scatter = std::max(1.0, fit.deviance);
  fit.posterior = classes_of(best.candidates, best.spectrum, scatter);
  fit.kinds = kinds_of(best.candidates, scatter);
  expected_cells(first.model, first.fit.nuisance, best.spectrum, fit.model);
  fit.spectrum = std::move(best.spectrum);

  const GreyLevels levels = grey_levels(grey, int(first.model.sequence.size()));
  fit.material.sequence = first.model.sequence;
  fit.material.kernel = options.kernel == HammerKernel::both ? "both" : "stretched";
  fit.material.levels = std::clamp(levels.highest, 1.0, 255.0);
  fit.material.step = levels.step;
  fit.sigma = fit.material;
  fit.sigma.levels = levels.highest_sigma;
  fit.sigma.step = levels.step_sigma;
  etched(surface, fit);
  fit.remarks.push_back(fmt::format(
      "The picture blurs the grain by {:.2f} px; white noise is {:.3g} and a step between levels "
      "{:.2g} of its standard deviation.",
      fit.nuisance.blur_px, std::sqrt(fit.nuisance.floor), fit.nuisance.step));
  if (fit.posterior.front().probability < 0.5) {
    fit.remarks.push_back("No sequence is more probable than all others together; see the list.");
  }
  if (fit.deviance > 1.5) {
    fit.remarks.push_back(fmt::format(
        "The spectrum departs from that of folded steel ({:.2g} times the scatter of chance): the "
        "probabilities allow for that.",
        fit.deviance));
  }
  if (levels.step <= 0.0) {
    fit.remarks.push_back("The grey values show no levels; step is 0 and levels is their range.");
  }
  return fit;
}

}  // namespace hada
