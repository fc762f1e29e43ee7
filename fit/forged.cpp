#include "fit/forged.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/srgb.h"
#include "fit/grain_view.h"
#include "fit/grey_levels.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 64;
constexpr int most_rows = 2048, most_cols = 4096;  // of a picture; the middle of a larger one

Grid<float> middle(const Grid<float>& picture, int rows, int cols) {
  return crop(picture, (picture.rows() - rows) / 2, (picture.cols() - cols) / 2, rows, cols);
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
  grey = middle(grey, std::min(grey.rows(), most_rows), std::min(grey.cols(), most_cols));
  if (!surface.albedo.empty()) {
    for (float& g : grey) g = 255.0f * srgb_from_linear(std::clamp(g, 0.0f, 1.0f));
  }
  return grey;
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

/// Nats to the best of another sequence.
double runner_up_gap(const std::vector<SequenceCandidate>& all, const SequenceCandidate& first) {
  double gap = HUGE_VAL;
  for (const auto& one : all) {
    if (one.model.sequence != first.model.sequence) gap = std::min(gap, one.loss() - first.loss());
  }
  return gap;
}

}  // namespace

ForgedFit fit_forged(const Surface& surface, const ForgedFitOptions& options) {
  const Grid<float> grey = grey_of(surface);
  SeenGrain seen = seen_grain(grey,
                              {.fewest_folds = options.fewest_folds,
                               .most_folds = options.most_folds,
                               .kernel = options.kernel},
                              options.view == GrainView::automatic);

  ForgedFit fit;
  const auto least =
      std::min_element(seen.candidates.begin(), seen.candidates.end(),
                       [](const auto& a, const auto& b) { return a.fit.cost < b.fit.cost; });
  const auto cells = std::count_if(seen.spectrum.count.begin(), seen.spectrum.count.end(),
                                   [](double count) { return count > 0.0; });
  fit.deviance = 2.0 * least->fit.cost / double(cells);
  auto posterior = sequence_posterior(seen.candidates, seen.spectrum, std::max(1.0, fit.deviance));
  const SequenceCandidate& first = posterior.likeliest;
  fit.posterior = std::move(posterior.classes);
  fit.kinds = posterior.kinds;
  fit.nuisance = first.fit.nuisance;
  fit.rotation_rad = seen.rotation_rad;
  fit.cost = first.fit.cost;
  fit.runner_up_gap = runner_up_gap(seen.candidates, first);
  fit.starts = int(seen.candidates.size());
  fit.agreeing = 1;
  expected_cells(first.model, first.fit.nuisance, seen.spectrum, fit.model);
  fit.spectrum = std::move(seen.spectrum);

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
  if (fit.rotation_rad != 0.0) {
    fit.remarks.push_back(
        fmt::format("The rows of the block run {:.2f} degrees {} those of the picture.",
                    std::abs(fit.rotation_rad) * 180.0 / std::numbers::pi,
                    fit.rotation_rad > 0.0 ? "up against" : "down against"));
  }
  if (fit.nuisance.scale != 1.0) {
    fit.remarks.push_back(fmt::format("A place of the block is {:.3f} px wide and {:.3f} px high.",
                                      fit.nuisance.scale * fit.nuisance.aspect,
                                      fit.nuisance.scale));
  }
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
