// hada_bench_knit [seeds] [DATA]: how knits come to rest, are worn, calibrated and counted.
#include <cstdio>
#include <cstdlib>

#include "bench/knit_study.h"
#include "bench/knit_tracking_study.h"

int main(int count, char** words) {
  const int seeds = count > 1 ? std::atoi(words[1]) : 40;
  const auto patch = hada::study_patch();
  std::printf("patch of 10 x 10: %d steps of the paper; Newton within %.1e pitches of their end\n",
              patch.steps, patch.rest_apart);
  for (const int size : {100, 300})
    std::printf("%d x %d to rest: %.2f s\n", size, size, hada::seconds_to_rest(size));
  for (const int size : {150, 300}) {
    const auto wear = hada::study_wear(size);
    std::printf("%d x %d on the leg: %.2f s, %d steps%s; inside the leg before %d, after %d\n",
                size, size, wear.seconds, wear.steps, wear.settled ? "" : " (not settled)",
                wear.cut, wear.penetrating);
  }
  std::fflush(stdout);
  using hada::KnitClamp, hada::KnitPull;
  for (const auto clamp : {KnitClamp::uniform, KnitClamp::three_points}) {
    for (const auto pull : {KnitPull::wale, KnitPull::course}) {
      const auto bound = hada::clamp_bounds(pull, clamp);
      std::printf("%s clamps, along the %ss: rank %d, ratio known to %.3g, c to %.3g\n",
                  clamp == KnitClamp::uniform ? "uniform" : "three-point",
                  pull == KnitPull::wale ? "wale" : "course", bound.rank, 10.0 * bound.log_ratio,
                  bound.continuity);
    }
  }
  const auto s = hada::study_stiffness(seeds);
  std::printf(
      "%d fits: ratio +- %.4f (bound %.4f), c +- %.5f (bound %.5f), 95 %% intervals hold %.1f %%; "
      "%.2f s each\n",
      seeds, s.ratio_spread, s.ratio_bound, s.continuity_spread, s.continuity_bound,
      100.0 * s.coverage, s.seconds_median);
  std::fflush(stdout);
  const auto t = hada::study_tracking(seeds / 10);
  std::printf(
      "%d of %d pairs of photographs: crossings +- %.3f px (%.4f wales); ratio off %.4f (sigma "
      "%.4f), c off %.5f (sigma %.5f), 95 %% intervals hold %.1f %%; %.1f s each\n",
      t.found, t.trials, t.off_px, t.off_wales, t.ratio_error, t.ratio_sigma, t.continuity_error,
      t.continuity_sigma, 100.0 * t.coverage, t.seconds);
  std::fflush(stdout);
  const auto lattice = hada::study_lattice(12);
  std::printf("12 made pictures: wale %.4f %% (median %.4f), course %.4f %% (median %.4f)\n",
              100.0 * lattice.wale, 100.0 * lattice.wale_median, 100.0 * lattice.course,
              100.0 * lattice.course_median);
  if (count < 3) return 0;
  const std::filesystem::path data = words[2];
  for (const auto& r : hada::score_rendered_knits(data / "rendered" / "knit_flat")) {
    std::printf(
        "%s: wale %.3f %%, course %.3f %%, rotation %.3f deg, radius %.2f %%, gradients %.1f "
        "%%, repeat %s\n",
        r.name.c_str(), 100.0 * r.wale, 100.0 * r.course, r.rotation_deg, 100.0 * r.radius,
        100.0 * r.gradient, r.repeat ? "exact" : "wrong");
  }
  const auto hand = hada::count_hand_knit(data / "knit" / "whichstitch_stockinette.jpg");
  std::printf("hand knit: %.3f wales, %.3f courses\n", hand[0], hand[1]);
  std::printf(
      "jersey: peaks within %.5f cycles\n",
      hada::jersey_peak_error(data / "knit" / "jersey_authored" / "Fabric_Knitted_006_height.png"));
}
