#include "app/validation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/comparison.h"
#include "app/fit_material.h"
#include "app/lit_capture.h"
#include "app/part_order.h"
#include "app/telling.h"
#include "app/virtual_capture.h"
#include "core/error.h"
#include "io/json.h"
#include "reconstruct/reconstruct.h"

namespace hada {
namespace {

// The ends of +-1.96 sigma hold 95 % where the fit has no interval of its own.
Material lower_or_upper(const MaterialFile& fitted, double sigmas) {
  const std::vector<double> sigma = values_of(*fitted.sigma);
  Material ends = fitted.material;
  std::size_t next = 0;
  const auto set = [&](const std::string& path, const auto&, double& value) {
    value += sigmas * sigma[next++];
    for (const auto& interval : fitted.intervals) {
      if (interval.path == path) value = sigmas < 0.0 ? interval.low : interval.high;
    }
  };
  std::visit([&](auto& m) { visit_fields(m, set); }, ends);
  return ends;
}

SeedAccuracy one_seed(Recipe recipe, Seed seed) {
  recipe.sheet_seed = seed;
  recipe.rig.seed = seed;
  const Terminal silent({.quiet = true});
  const VirtualCapture capture = virtual_capture(recipe);
  const LitCapture lit = lit_capture(as_loaded(capture, recipe), {}, silent);
  const Reconstruction made = reconstruct(lit.stack);
  const Comparison comparison = compare(made.surface, capture.truth);
  const MaterialFile fitted =
      fit_material(std::string(name_of(recipe.material)), made.surface, recipe.name);
  if (part_count(fitted.material) < part_count(recipe.material)) {
    throw Error("the fit found " + std::to_string(part_count(fitted.material)) + " of " +
                std::to_string(part_count(recipe.material)) +
                " components; a larger sheet or less noise would show them");
  }

  SeedAccuracy accuracy;
  accuracy.seed = seed;
  accuracy.lights_deg = mean_deg(light_errors(lit.lights.lights, capture.stack.lights));
  if (comparison.overlap) {
    accuracy.normals_deg = comparison.overlap->normal_mean * 180.0 / std::numbers::pi;
    accuracy.height_percent =
        100.0 * comparison.overlap->height_rmse / comparison.overlap->height_std;
  }
  const std::vector<int> order = part_order(fitted.material, recipe.material);
  accuracy.found = values_of(reordered(fitted.material, order));
  accuracy.sigma = values_of(reordered(*fitted.sigma, order));
  accuracy.low = values_of(reordered(lower_or_upper(fitted, -1.96), order));
  accuracy.high = values_of(reordered(lower_or_upper(fitted, 1.96), order));
  return accuracy;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// Directions differ modulo half a turn.
double difference(Scale scale, double a, double b) {
  return scale == Scale::half_turn ? std::remainder(a - b, std::numbers::pi) : a - b;
}

std::vector<ParameterAccuracy> parameters_over(const std::vector<SeedAccuracy>& seeds,
                                               const Material& truth) {
  std::vector<ParameterAccuracy> parameters;
  std::size_t next = 0;
  const auto add = [&](const std::string& name, const auto& field, double value) {
    const std::size_t i = next++;
    if (is_left_out(field, value)) return;
    ParameterAccuracy p{.name = name, .unit = std::string(field.unit), .truth = value};
    std::vector<double> found, errors, sigmas;
    for (const auto& seed : seeds) {
      const double error = difference(field.scale, seed.found[i], value);
      found.push_back(value + error);
      errors.push_back(std::abs(error));
      sigmas.push_back(seed.sigma[i]);
      const double count = double(seeds.size());
      p.within_90 += std::abs(error) <= 1.6449 * seed.sigma[i] ? 1.0 / count : 0.0;
      const double middle = 0.5 * (seed.low[i] + seed.high[i]);
      const bool holds =
          std::abs(difference(field.scale, middle, value)) <= 0.5 * (seed.high[i] - seed.low[i]);
      p.within_95 += holds ? 1.0 / count : 0.0;
    }
    p.median = median(found);
    p.median_error = median(errors);
    p.median_sigma = median(sigmas);
    parameters.push_back(p);
  };
  std::visit([&](const auto& m) { visit_fields(m, add); }, truth);
  return parameters;
}

}  // namespace

Validation validate(const Recipe& recipe, int seeds, const Terminal& terminal) {
  Validation validation;
  for (int i = 0; i < seeds; ++i) {
    const Seed seed = recipe.sheet_seed + Seed(i);
    terminal.step("seed " + std::to_string(i + 1) + " of " + std::to_string(seeds));
    try {
      validation.seeds.push_back(one_seed(recipe, seed));
    } catch (const Error& error) {
      validation.failures.push_back("seed " + std::to_string(seed) + ": " + error.what());
    }
  }
  if (validation.seeds.empty()) throw Error(validation.failures.front());
  validation.parameters = parameters_over(validation.seeds, recipe.material);
  return validation;
}

std::string validation_text(const Validation& validation, const Recipe& recipe) {
  Json json = {{"hada", "validate/1"}, {"recipe", recipe.name}};
  for (const auto& seed : validation.seeds) {
    json["seeds"].push_back({{"seed", seed.seed},
                             {"lights_deg", seed.lights_deg},
                             {"normals_deg", seed.normals_deg},
                             {"height_percent", seed.height_percent}});
  }
  for (const auto& p : validation.parameters) {
    json["parameters"].push_back({{"name", p.name},
                                  {"unit", p.unit},
                                  {"truth", p.truth},
                                  {"median", p.median},
                                  {"median_error", p.median_error},
                                  {"median_sigma", p.median_sigma},
                                  {"within_90", p.within_90},
                                  {"within_95", p.within_95}});
  }
  json["failures"] = validation.failures;
  return json.dump(1) + "\n";
}

}  // namespace hada
