#include "bench/wrinkle_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

#include "bench/finer_sample.h"
#include "core/parallel.h"
#include "core/random.h"
#include "fit/wrinkle.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// The middle of a larger, finer field: every second pixel of it.
Surface sample_of(const Wrinkle<>& truth, const WrinkleStudyOptions& options, Seed seed) {
  const int n = options.size_px;
  const Extent world{4 * n, 4 * n, 0.5 * options.pitch_mm, Unit::mm};
  const auto field = synthesize(truth, world, seed).height;
  return finer_sample(field, n, {n, n, options.pitch_mm, Unit::mm}, options.noise_mm, seed + 1000);
}

struct Errors {
  std::vector<double> absolute;
  std::vector<double> sigma;
  std::vector<double> in_sigma;
};

double difference(double fitted, double truth, Scale scale) {
  if (scale == Scale::log) return fitted / truth - 1.0;
  constexpr double pi = std::numbers::pi;
  return half_turn(fitted - truth + 0.5 * pi) - 0.5 * pi;
}

FieldScore score(const std::string& path, const Errors& errors) {
  FieldScore result{
      .path = path, .median_error = median(errors.absolute), .median_sigma = median(errors.sigma)};
  double squares = 0.0;
  for (const double ratio : errors.in_sigma) {
    result.coverage += std::abs(ratio) < 1.959964 ? 1.0 : 0.0;
    squares += ratio * ratio;
    result.bias += ratio / double(errors.in_sigma.size());
  }
  const double n = double(errors.in_sigma.size());
  result.coverage /= n;
  result.spread = std::sqrt(squares / n);
  return result;
}

double processor_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// prepare  gives the work of a run; only the work is timed
template <class Prepare>
double seconds_of(int runs, const Prepare& prepare) {
  set_threads(1);
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) {
    const auto work = prepare(run);
    const double begin = processor_seconds();
    work();
    seconds.push_back(processor_seconds() - begin);
  }
  set_threads(0);
  return median(seconds);
}

}  // namespace

Wrinkle<> study_truth(unsigned seed, double pitch_mm) {
  Wrinkle<> truth{.components = {}};
  const double size_px[] = {16.0, 5.0, 1.7};
  const double amplitude_px[] = {0.5, 0.15, 0.05};
  for (int k = 0; k < 3; ++k) {
    const auto draw = [&](int what) { return uniform(9000 + seed, k, what); };
    const double ratio = 1.5 * std::pow(2.0, draw(0));  // 1.5 to 3
    const double size = size_px[k] * pitch_mm * (0.9 + 0.2 * draw(1));
    truth.components.push_back({.amplitude_mm = amplitude_px[k] * (0.7 + 0.6 * draw(2)),
                                .long_mm = size * std::sqrt(ratio),
                                .short_mm = size / std::sqrt(ratio),
                                .angle_rad = std::numbers::pi * draw(3)});
  }
  return truth;
}

WrinkleScore study_wrinkles(const WrinkleStudyOptions& options) {
  std::vector<std::string> paths;
  std::vector<Errors> errors;
  std::vector<double> seconds;
  WrinkleScore result;
  for (int seed = 0; seed < options.seeds; ++seed) {
    const auto truth = study_truth(unsigned(seed), options.pitch_mm);
    const auto sample = sample_of(truth, options, Seed(seed));
    const auto begin = std::chrono::steady_clock::now();
    const auto fit = fit_wrinkle(sample, {.components = options.components});
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    result.goodness.push_back(fit.goodness_p);
    result.agreeing.push_back(double(fit.agreeing) / fit.starts);
    if (fit.material.components.size() != truth.components.size()) continue;
    result.right_count += 1.0 / options.seeds;

    std::vector<double> true_values, sigmas;
    visit_fields(truth, [&](const std::string&, const auto&, double value) {
      true_values.push_back(value);
    });
    visit_fields(fit.sigma,
                 [&](const std::string&, const auto&, double value) { sigmas.push_back(value); });
    paths.clear();
    std::size_t k = 0;
    visit_fields(fit.material, [&](const std::string& path, const auto& field, double value) {
      paths.push_back(path);
      errors.resize(std::max(errors.size(), paths.size()));
      const double error = difference(value, true_values[k], field.scale);
      const double unit = field.scale == Scale::log ? value : 1.0;
      const double degrees = 180.0 / std::numbers::pi;
      const double shown = field.scale == Scale::half_turn ? degrees : 1.0;
      errors[k].absolute.push_back(std::abs(error) * shown);
      errors[k].sigma.push_back(sigmas[k] / unit * shown);
      errors[k].in_sigma.push_back((field.scale == Scale::log ? std::log1p(error) : error) /
                                   (sigmas[k] / unit));
      ++k;
    });
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (paths[k].find('.') == std::string::npos) continue;  // the floor, whose truth is 0
    result.fields.push_back(score(paths[k], errors[k]));
    result.coverage += result.fields.back().coverage;
  }
  result.coverage /= double(result.fields.size());
  result.seconds_median = median(seconds);
  return result;
}

double study_component_count(int maps) {
  int right = 0;
  for (int map = 0; map < maps; ++map) {
    const int count = 1 + map % 4;
    Wrinkle<> truth{.components = {}};
    double size_mm = 0.2 * (1.3 + 0.4 * uniform(8000, map, 0));
    double amplitude_mm = 0.02;
    for (int k = 0; k < count; ++k) {
      const double ratio = 1.3 + uniform(8000, map, 10 + k);
      truth.components.push_back({.amplitude_mm = amplitude_mm,
                                  .long_mm = size_mm * std::sqrt(ratio),
                                  .short_mm = size_mm / std::sqrt(ratio),
                                  .angle_rad = std::numbers::pi * uniform(8000, map, 20 + k)});
      size_mm *= 2.0 + 0.5 * uniform(8000, map, 30 + k);
      amplitude_mm *= 2.5;
    }
    const auto fit = fit_wrinkle(sample_of(truth, {.noise_mm = 0.002}, Seed(500 + map)));
    right += int(fit.material.components.size()) == count ? 1 : 0;
  }
  return double(right) / maps;
}

double wrinkle_fit_seconds(int runs) {
  return seconds_of(runs, [&](int run) {
    const auto sample = sample_of(study_truth(unsigned(run), 0.2), {.noise_mm = 0.003}, Seed(run));
    return [sample] { fit_wrinkle(sample, {.components = 3}); };
  });
}

double synthesis_seconds(int side_px, int runs) {
  return seconds_of(runs, [&](int run) {
    return [=] {
      synthesize(study_truth(unsigned(run), 0.2), {side_px, side_px, 0.2, Unit::mm}, 1);
    };
  });
}

}  // namespace hada
