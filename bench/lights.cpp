// hada_bench_lights [seeds]: errors and intervals of lights on virtual captures.
#include <cstdio>
#include <cstdlib>

#include "bench/light_study.h"

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 10;
  const auto tell = [](const char* name, const hada::LightStudy& study) {
    std::printf("%-16s error %.3f deg, 90 %% intervals hold %.1f %%, z %.2f, places %.2f mm (%d)\n",
                name, study.median_error_deg, 100.0 * study.coverage90, study.typical_z,
                study.position_mm, study.components);
  };
  tell("matte, distant", hada::study_lights({.seeds = seeds}));
  tell("chrome, distant", hada::study_lights({.seeds = seeds, .chrome = true}));
  tell("matte, near", hada::study_lights({.seeds = seeds, .near = true}));
}
