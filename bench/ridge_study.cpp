#include "bench/ridge_study.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "bench/finer_sample.h"
#include "core/quantile.h"
#include "core/random.h"
#include "fit/wrinkle.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

double processor_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

Surface sample_of(const Wrinkle<>& truth, const RidgeStudyOptions& options, Seed seed) {
  const int n = options.size_px;
  const Extent world{3 * n, 3 * n, 0.5 * options.pitch_mm, Unit::mm};
  const auto field = synthesize(truth, world, seed).height;
  Surface sample =
      finer_sample(field, n / 2, {n, n, options.pitch_mm, Unit::mm}, options.noise_mm, seed + 1);
  for (float& height : sample.height)
    height = float(std::round(height / options.step_mm) * options.step_mm);
  return sample;
}

}  // namespace

Wrinkle<> ridge_truth(unsigned seed) {
  const auto draw = [&](int what, double low, double high) {
    return low + (high - low) * uniform(31000 + seed, what, 0);
  };
  Wrinkle<> truth{.components = {}};
  for (const auto& [size_mm, amplitude_mm, k] : {std::tuple{1.4, 0.25, 0}, {0.5, 0.04, 10}}) {
    const double ratio = draw(k, 1.2, 2.5), size = size_mm * draw(k + 1, 0.8, 1.2);
    truth.components.push_back({.amplitude_mm = amplitude_mm * draw(k + 2, 0.7, 1.3),
                                .long_mm = size * std::sqrt(ratio),
                                .short_mm = size / std::sqrt(ratio),
                                .angle_rad = draw(k + 3, 0.0, std::numbers::pi)});
  }
  truth.skew = draw(20, -0.5, 0.5);
  truth.tail = draw(21, -0.2, 0.25);
  truth.sharpness = draw(22, -3.0, 3.0);
  return truth;
}

std::vector<RidgeCase> study_ridges(const RidgeStudyOptions& options) {
  std::vector<RidgeCase> cases;
  for (int map = options.first; map < options.first + options.maps; ++map) {
    const auto truth = ridge_truth(unsigned(map));
    const auto sample = sample_of(truth, options, Seed(770000 + 2 * map));
    const double begin = processor_seconds();
    const auto fit = fit_wrinkle(sample, {.components = 2, .ridges = true});
    cases.push_back({.truth = {truth.skew, truth.tail, truth.sharpness},
                     .found = {fit.material.skew, fit.material.tail, fit.material.sharpness},
                     .sigma = {fit.sigma.skew, fit.sigma.tail, fit.sigma.sharpness},
                     .departure = fit.ridges.departure,
                     .left = fit.ridges.left,
                     .seconds = processor_seconds() - begin});
  }
  return cases;
}

RidgeScore score_of(const std::vector<RidgeCase>& cases, std::size_t which) {
  std::vector<double> errors, sigmas;
  RidgeScore score{};
  const double n = double(cases.size());
  for (const auto& one : cases) {
    const double error = one.found[which] - one.truth[which], in_sigma = error / one.sigma[which];
    errors.push_back(std::abs(error));
    sigmas.push_back(one.sigma[which]);
    score.coverage += (std::abs(in_sigma) < 1.959964 ? 1.0 : 0.0) / n;
    score.spread += in_sigma * in_sigma / n;
    score.bias += in_sigma / n;
  }
  score.spread = std::sqrt(score.spread);
  score.median_error = median(errors);
  score.median_sigma = median(sigmas);
  return score;
}

}  // namespace hada
