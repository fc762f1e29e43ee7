#pragma once

#include <vector>

#include "reconstruct/estimator.h"

namespace hada {

/// Processor time of normals, in nanoseconds per pixel of one thread, from pictures in memory into
/// maps in memory: normals, albedo and mask of every pixel; without the second pass that makes the
/// sigmas.
///
/// Goal at 4096 x 4096 on an idle machine: least-squares at most 3, adaptive (the default) at
/// most 20.
///
/// The pictures are those of a matte relief under twelve distant lights, grey, with noise; on a
/// tenth of the pixels one sample is a highlight or a shadow that nobody has marked. Each figure is
/// the best of five runs, and each run is timed beside a plain read of the same pictures, which
/// tells what the memory allowed meanwhile.
struct NormalSpeed {
  Estimator estimator;
  double nanoseconds = 0.0;
  double with_uncertainty = 0.0;  // the same, with the maps of sigma; 0: not measured
  double plain_read = 0.0;        // summing all samples up
};

struct NormalSpeedOptions {
  int side = 4096;
  bool uncertainty = false;  // whether `with_uncertainty` is measured
};

std::vector<NormalSpeed> normal_speed(const std::vector<Estimator>& estimators,
                                      const NormalSpeedOptions& options = {});

}  // namespace hada
