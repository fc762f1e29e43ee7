#pragma once

#include <string>
#include <vector>

#include "reconstruct/estimator.h"

namespace hada {

/// Time of normals, in nanoseconds per pixel of one thread, from pictures in memory into maps in
/// memory: normals, albedo and mask of every pixel; without the second pass that makes the sigmas.
///
/// The pictures are those of a matte relief under twelve distant lights, grey, with noise; on a
/// tenth of the pixels one sample is a highlight or a shadow that nobody has marked.
struct NormalSpeed {
  Estimator estimator;
  double nanoseconds = 0.0;       // the best of the runs
  double with_uncertainty = 0.0;  // the same, with the maps of sigma
};
std::vector<NormalSpeed> normal_speed(int rows, int cols, const std::vector<Estimator>& estimators);

}  // namespace hada
