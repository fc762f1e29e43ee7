// hada_bench_normals [scene] [estimator] [tilt_deg gain]: angular errors against known normals.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/accuracy.h"
#include "bench/normals_study.h"

int main(int argc, char** argv) {
  const std::string only_scene = argc > 1 ? argv[1] : "all";
  const std::string only_estimator = argc > 2 ? argv[2] : "all";
  const double tilt_deg = argc > 3 ? std::atof(argv[3]) : 0.0;
  const double gain = argc > 4 ? std::atof(argv[4]) : 0.0;
  for (const auto& name : hada::normal_scenes()) {
    if (only_scene != "all" && name != only_scene) continue;
    hada::NormalScene scene = hada::normal_scene(hada::data_folder(), name);
    if (tilt_deg > 0.0 || gain > 0.0) {
      scene = hada::with_errors_of_lights(std::move(scene), tilt_deg, gain, 1);
    }
    for (const auto estimator : hada::every_estimator) {
      const std::string called(hada::name_of(estimator));
      if (only_estimator != "all" && only_estimator != called) continue;
      const auto score = hada::normal_score(scene, estimator);
      std::printf(
          "%-22s %-18s %.3f deg mean, %.3f median, 90 %% holds %.0f %%, solved %.1f %%, %.1f s; "
          "%s\n",
          name.c_str(), called.c_str(), score.mean_deg, score.median_deg, 100.0 * score.within_90,
          100.0 * score.solved, score.seconds, score.told.c_str());
      std::fflush(stdout);
    }
  }
  return 0;
}
