// hada_bench_normals_time [side]: nanoseconds per pixel and thread, twelve grey lights.
// Goal: least-squares 3 ns or less, adaptive (the default) 20 ns or less.
#include <cstdio>
#include <cstdlib>

#include "bench/normals_speed.h"

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 4096;
  const std::vector<hada::Estimator> estimators = {
      hada::Estimator::least_squares, hada::Estimator::lit_least_squares,
      hada::Estimator::trimmed,       hada::Estimator::huber,
      hada::Estimator::biweight,      hada::Estimator::adaptive};
  for (const auto& speed : hada::normal_speed(side, side, estimators)) {
    std::printf("%-18s %6.2f ns per pixel, %6.2f with sigmas\n",
                hada::name_of(speed.estimator).data(), speed.nanoseconds, speed.with_uncertainty);
  }
  return 0;
}
