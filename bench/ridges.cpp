#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/ridge_picture.h"
#include "bench/ridge_study.h"

// hada_bench_ridges [maps] [first] [side in pixels], or hada_bench_ridges picture.png
int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]).ends_with(".png")) {
    hada::write_ridges_picture(argv[1]);
    return 0;
  }
  hada::RidgeStudyOptions options;
  if (argc > 1) options.maps = std::atoi(argv[1]);
  if (argc > 2) options.first = std::atoi(argv[2]);
  if (argc > 3) options.size_px = std::atoi(argv[3]);
  const auto cases = hada::study_ridges(options);
  for (const auto& one : cases) {
    for (std::size_t k = 0; k < 3; ++k)
      std::printf("%7.3f %7.3f +- %5.3f %5.1f |", one.truth[k], one.found[k], one.sigma[k],
                  (one.found[k] - one.truth[k]) / one.sigma[k]);
    std::printf(" %8.0f %6.0f %6.1f s\n", one.departure, one.left, one.seconds);
  }
  const char* names[] = {"skew", "tail", "sharpness"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto score = hada::score_of(cases, k);
    std::printf("%-10s error %.3f sigma %.3f, 95 %% holds %.1f %%, rms/sig %.2f, bias/sig %.2f\n",
                names[k], score.median_error, score.median_sigma, 100.0 * score.coverage,
                score.spread, score.bias);
  }
}
