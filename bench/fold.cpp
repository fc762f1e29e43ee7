// hada_bench_fold DATA: crease patterns and sheets of the collection in DATA/fold, against what
// others found.
#include <cstdio>
#include <filesystem>

#include "bench/crease_study.h"
#include "bench/fold_motion_study.h"
#include "bench/fold_study.h"

int main(int argc, char** argv) {
  if (argc < 2 || !std::filesystem::exists(std::filesystem::path(argv[1]) / "fold")) {
    std::fprintf(stderr, "usage: hada_bench_fold DATA, a folder that holds fold/\n");
    return 2;
  }
  const std::filesystem::path data = argv[1];
  for (const auto& score : hada::score_patterns(data)) {
    std::printf("%-45s %4d faces  geometry %.1e  states %s of %s  %.1f ms\n", score.name.c_str(),
                score.faces, score.geometry_error, score.states.c_str(),
                score.states_published.c_str(), score.milliseconds);
  }
  for (const auto& rejection : hada::score_unfoldable(data)) {
    std::printf("%-45s %s\n", rejection.name.c_str(), rejection.reason.c_str());
  }
  for (const auto& speed : hada::spring_speeds()) {
    std::printf("%-20s %d faces: %.2e faces x steps / s, %d substeps\n", speed.name.c_str(),
                speed.faces, speed.faces_steps_per_second, speed.substeps);
  }
  for (const auto& score : hada::exact_scores()) {
    std::printf("exact, %d faces: strain %.1e, planarity %.1e, %.1f ms\n", score.faces,
                score.strain, score.planarity, score.milliseconds);
  }
  std::printf("Miura against its closed form: %.1e deg\n", hada::miura_error_deg());
  for (const auto& score : hada::driven_scores(data)) {
    std::printf("%-14s at %4d %%: %.1e of the sheet\n", score.name.c_str(), score.percent,
                score.error);
  }
  const auto creases = hada::study_creases();
  std::printf(
      "creases from pictures: %d of %d found, %.3f deg rms, %.3f at most, lines %.3f px rms\n",
      creases.found, creases.creases, creases.rms_deg, creases.worst_deg, creases.line_rms_px);
  const auto true_lights = hada::study_creases({.light_error_deg = 0.0});
  std::printf("the same with true lights: %.3f deg rms, 90 %% intervals hold %.0f %%\n",
              true_lights.rms_deg, 100.0 * true_lights.coverage90);
  const auto shallow = hada::study_creases({.fold_low_deg = 2.0, .fold_high_deg = 2.5});
  std::printf("folds of 2 to 2.5 deg: %d of %d found\n", shallow.found, shallow.creases);
  return 0;
}
