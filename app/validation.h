#pragma once

#include <string>
#include <vector>

#include "app/recipe.h"
#include "app/terminal.h"

namespace hada {

/// How well one parameter is found, over the seeds that went through.
struct ParameterAccuracy {
  std::string name;
  std::string unit;
  double truth = 0.0;
  double median = 0.0;        // of what was found
  double median_error = 0.0;  // of the absolute error, in the unit
  double median_sigma = 0.0;  // of what the fit claims
  double within_90 = 0.0;     // share of seeds whose 90 % interval holds the truth
  double within_95 = 0.0;
};

/// What one virtual capture gave.
struct SeedAccuracy {
  Seed seed = 0;
  double lights_deg = 0.0;      // mean angle
  double normals_deg = 0.0;     // mean angle
  double height_percent = 0.0;  // root mean square error over the standard deviation
  std::vector<double> found;    // parameters, in the order of the field table
  std::vector<double> sigma;
  std::vector<double> low, high;  // ends of the 95 % intervals
};

struct Validation {
  std::vector<SeedAccuracy> seeds;
  std::vector<ParameterAccuracy> parameters;
  std::vector<std::string> failures;  // "seed 3: no sphere was found ..."
};

/// Synthesises, photographs, reconstructs and fits the material of `recipe` with `seeds` seeds,
/// from that of the recipe on; sheet, sensor noise and fit know nothing of each other.
///
/// throws  Error if no seed goes through, with the reason of the first
Validation validate(const Recipe& recipe, int seeds, const Terminal& terminal);

std::string validation_text(const Validation& validation, const Recipe& recipe);

}  // namespace hada
