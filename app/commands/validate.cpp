#include "app/commands/validate.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/files.h"
#include "app/validation.h"
#include "io/output.h"

namespace hada {
namespace {

// Smallest, mean and largest of one figure over the seeds.
std::string spread(const Validation& validation, double SeedAccuracy::*figure) {
  double sum = 0.0;
  double low = HUGE_VAL;
  double high = 0.0;
  for (const auto& seed : validation.seeds) {
    sum += seed.*figure;
    low = std::min(low, seed.*figure);
    high = std::max(high, seed.*figure);
  }
  return fmt::format("{:>8.3f} {:>8.3f} {:>8.3f}", low, sum / double(validation.seeds.size()),
                     high);
}

void tell(const Validation& validation, const Terminal& terminal) {
  terminal.say(
      fmt::format("{:<24} {:>8} {:>8} {:>8}", "error over the seeds", "least", "mean", "most"));
  terminal.say("lights, deg              " + spread(validation, &SeedAccuracy::lights_deg));
  terminal.say("normals, deg (mean)      " + spread(validation, &SeedAccuracy::normals_deg));
  terminal.say("height, % of its spread  " + spread(validation, &SeedAccuracy::height_percent));
  terminal.say(fmt::format("{:<28} {:>10} {:>10} {:>10} {:>10} {:>6} {:>6}", "parameter", "truth",
                           "median", "|error|", "sigma", "in 90%", "in 95%"));
  for (const auto& p : validation.parameters) {
    terminal.say(fmt::format("{:<28} {:>10.4g} {:>10.4g} {:>10.3g} {:>10.3g} {:>5.0f}% {:>5.0f}%",
                             p.name, p.truth, p.median, p.median_error, p.median_sigma,
                             100.0 * p.within_90, 100.0 * p.within_95));
  }
  for (const auto& failure : validation.failures) terminal.say("failed: " + failure);
}

}  // namespace

void validate_command(const ValidateArguments& arguments, const Terminal& terminal) {
  const Recipe recipe = read_recipe(arguments.recipe);
  const Validation validation = validate(recipe, arguments.seeds, terminal);
  const std::string text = validation_text(validation, recipe);
  if (arguments.out) {
    Output output(*arguments.out);
    put_text(output, "validate.json", text);
    output.commit();
  }
  tell(validation, terminal);
  if (arguments.out) terminal.say("wrote " + (*arguments.out / "validate.json").string());
  terminal.result(text);
}

}  // namespace hada
