#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/grid.h"
#include "core/surface.h"
#include "synth/knit.h"

namespace hada {

/// The yarn that is seen at each pixel.
struct KnitMaps {
  Grid<float> height;         // mm over the middle of the fabric; the lowest yarn in holes
  NormalMap normals;          // of the yarn; (0, 0, 1) in holes
  Grid<std::int16_t> course;  // which course of the repeat, 0 and up; -1 in holes
};

/// A loop of yarn on its way to a picture: points of the middle of the yarn in pixels.
struct YarnPoint {
  double row, col;
  double height_mm;
  int course;
};

/// What is seen from above of a yarn of this radius through `points`: the highest sphere over every
/// pixel. Where `wraps`, the picture is a torus.
///
/// mm_per_px  along columns and rows; the yarn is round in mm
KnitMaps seen_from_above(const std::vector<YarnPoint>& points, double radius_mm, int rows, int cols,
                         std::array<double, 2> mm_per_px, bool wraps);

/// Points of the loop whose head is at wale 0 of course 0, dense enough for `seen_from_above`:
/// wales, courses and mm.
std::vector<std::array<double, 3>> loop_curve(const Knit<>& knit);

struct KnitPictureOptions {
  double jitter_mm = 0.0;  // standard deviation of the place of each loop, along x and y
};

/// The knit as it is, gradients included, where `extent` looks at it; it does not tile.
KnitMaps knit_maps(const Knit<>& knit, const Extent& extent, Seed seed,
                   const KnitPictureOptions& options = {});

}  // namespace hada
