#pragma once

#include <vector>

#include "capture/load.h"
#include "core/grid.h"

namespace hada {

/// What all pictures together show, in two lights: the mean of the logarithms (outlines of dark
/// things against dark tables) and the brightest of all (whole discs of matte spheres).
struct Overview {
  std::vector<Grid<float>> greys;  // linear
  std::vector<float> bright;       // of each picture: the 99th percentile
  std::vector<float> glint;        // of each picture: the largest value
  Grid<float> mean_log;
  Grid<float> brightest;
  Grid<float> brightest_log;
};

/// linear  how the pictures are read: as linear values or as sRGB
Overview overview(const Photographs& photographs, bool linear);

/// Read as they say of themselves.
inline Overview overview(const Photographs& photographs) {
  return overview(photographs, photographs.linear);
}

}  // namespace hada
