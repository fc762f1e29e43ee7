#include "bench/results_ridges.h"

#include <cstdio>

#include <fmt/format.h>

#include "bench/results_page.h"
#include "bench/ridge_study.h"
#include "core/quantile.h"

namespace hada {

std::string ridge_results() {
  constexpr int maps = 48;
  std::string page =
      table("Ridges beyond the spectrum",
            "| parameter | median error | median sigma | 95 % intervals hold the truth | must be | "
            "rms error in sigmas | |");
  std::fprintf(stderr, "ridges of %d maps\n", maps);
  const auto cases = study_ridges({.maps = maps});
  const char* names[] = {"skew", "tail", "sharpness"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto score = score_of(cases, k);
    page += row({names[k], fmt::format("{:.3f}", score.median_error),
                 fmt::format("{:.3f}", score.median_sigma),
                 fmt::format("{:.1f} % of {}", 100.0 * score.coverage, maps), "90 to 98 %",
                 fmt::format("{:.2f}", score.spread),
                 verdict(score.coverage >= 0.90 && score.coverage <= 0.98)});
  }
  std::vector<double> explained, seconds;
  for (const auto& one : cases) {
    explained.push_back(100.0 * (1.0 - one.left / one.departure));
    seconds.push_back(one.seconds);
  }
  return page + fmt::format(
                    "\nMaps of 256 x 256 pixels, each of other skew (-0.5 to 0.5), tail (-0.2 to "
                    "0.25), sharpness (-3 to 3) and spectrum, cut from sheets made at half the "
                    "pitch, with noise of 1 um, rounded to 0.5 um; the spectrum is fitted too. "
                    "Ridges explain {:.0f} % (median) of how moments depart from a Gaussian sheet. "
                    "{:.1f} s of the processor a map.\n",
                    median(explained), median(seconds));
}

}  // namespace hada
