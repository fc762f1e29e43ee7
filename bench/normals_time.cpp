// hada_bench_normals_time [side] [estimator] [sigmas]: nanoseconds per pixel of one thread.
// Goal: least-squares 3 ns or less, adaptive (the default) 20 ns or less; see normals_speed.h.
#include <cstdio>
#include <cstdlib>

#include "bench/normals_speed.h"

int main(int argc, char** argv) {
  hada::NormalSpeedOptions options;
  if (argc > 1) options.side = std::atoi(argv[1]);
  std::vector<hada::Estimator> estimators = {hada::Estimator::least_squares,
                                             hada::default_estimator};
  if (argc > 2) {
    const auto only = hada::estimator_named(argv[2]);
    if (!only) {
      std::fprintf(stderr, "%s is no estimator; these are: %s\n", argv[2],
                   hada::estimator_names().c_str());
      return 1;
    }
    estimators = {*only};
  }
  options.uncertainty = argc > 3;
  for (const auto& speed : hada::normal_speed(estimators, options)) {
    std::printf("%-18s %6.2f ns per pixel beside a plain read of %.2f",
                hada::name_of(speed.estimator).data(), speed.nanoseconds, speed.plain_read);
    if (options.uncertainty) std::printf(", %.2f with sigmas", speed.with_uncertainty);
    std::printf("\n");
  }
  return 0;
}
