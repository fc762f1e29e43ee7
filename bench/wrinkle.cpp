#include <cstdio>
#include <cstdlib>

#include "bench/wrinkle_study.h"

// hada_bench_wrinkle [seeds] [components, 0: chosen] [noise_mm]
int main(int argc, char** argv) {
  hada::WrinkleStudyOptions options;
  if (argc > 1) options.seeds = std::atoi(argv[1]);
  if (argc > 2) options.components = std::atoi(argv[2]);
  if (argc > 3) options.noise_mm = std::atof(argv[3]);
  const auto score = hada::study_wrinkles(options);
  std::printf("%-30s %14s %10s %8s %8s\n", "field", "median error", "95 % holds", "bias/sig",
              "rms/sig");
  for (const auto& field : score.fields) {
    const bool angle = field.path.find("angle") != std::string::npos;
    std::printf("%-30s %10.3f %-3s %8.1f %% %8.2f %8.2f\n", field.path.c_str(),
                angle ? field.median_error : 100.0 * field.median_error, angle ? "deg" : "%",
                100.0 * field.coverage, field.bias, field.spread);
  }
  double agreeing = 0.0;
  for (const double share : score.agreeing) agreeing += share / double(score.agreeing.size());
  std::printf("coverage %.1f %%, components right %.1f %%, starts agreeing %.0f %%, %.2f s a fit\n",
              100.0 * score.coverage, 100.0 * score.right_count, 100.0 * agreeing,
              score.seconds_median);
  std::printf("goodness p:");
  for (const double p : score.goodness) std::printf(" %.2f", p);
  std::printf("\n");
}
