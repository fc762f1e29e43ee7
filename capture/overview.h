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

/// photographs  read as linear or as sRGB, as they say of themselves
Overview overview(const Photographs& photographs);

}  // namespace hada
