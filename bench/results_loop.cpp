#include "bench/results_loop.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "app/recipe.h"
#include "app/validation.h"
#include "bench/accuracy.h"
#include "bench/results_page.h"
#include "core/quantile.h"

namespace hada {

std::string virtual_captures() {
  std::vector<double> lights, normals, heights;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::fprintf(stderr, "virtual capture %u\n", seed);
    const auto score = synthetic_loop(seed);
    lights.push_back(score.lights_deg);
    normals.push_back(score.normals_deg);
    heights.push_back(100.0 * score.height_share);
  }
  const auto text = [](const std::vector<double>& v, const char* unit) {
    return fmt::format("{:.2f} {} median, {:.2f} worst of {}", median(v), unit,
                       *std::max_element(v.begin(), v.end()), v.size());
  };
  const auto worst = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end());
  };
  return table("Virtual captures: rendered 4 times finer, noise, 16 bits",
               "| figure | must be | measured | |") +
         row({"lights", "<= 0.3 deg mean", text(lights, "deg"), verdict(worst(lights) <= 0.3)}) +
         row({"normals", "<= 1.0 deg mean", text(normals, "deg"), verdict(worst(normals) <= 1.0)}) +
         row({"height, rms error over its standard deviation", "<= 2 %", text(heights, "%"),
              verdict(worst(heights) <= 2.0)});
}

// Synthesised, photographed, reconstructed and fitted: what is put in and what comes out.
std::string closed_loop() {
  constexpr int seeds = 16;
  std::fprintf(stderr, "closed loop\n");
  const Recipe recipe =
      read_recipe(std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic/sheet_and_spheres.json");
  const Validation validation = validate(recipe, seeds, Terminal({.quiet = true}));
  std::string page =
      table("Closed loop: wrinkles synthesised, photographed, reconstructed, fitted, 16 sheets",
            "| parameter | truth | median error | median sigma | 95 % intervals hold the truth |");
  double held = 0.0, count = 0.0;
  for (const ParameterAccuracy& p : validation.parameters) {
    if (p.truth == 0.0) continue;  // a floor that is not there
    held += p.within_95;
    count += 1.0;
    page +=
        row({p.name, fmt::format("{:.3g}", p.truth), fmt::format("{:.2g}", p.median_error),
             fmt::format("{:.2g}", p.median_sigma), fmt::format("{:.0f} %", 100.0 * p.within_95)});
  }
  const double share = count > 0.0 ? held / count : 0.0;
  return page + fmt::format(
                    "\n95 % intervals hold the truth in {:.1f} % of all (must be 90 %), {} of {} "
                    "sheets failed: {}.\n",
                    100.0 * share, validation.failures.size(), seeds,
                    verdict(share >= 0.90 && validation.failures.empty()));
}

}  // namespace hada
