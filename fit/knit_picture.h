#pragma once

#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "core/surface.h"

namespace hada {

/// A picture made small and even enough to explain: square roots of brightness, one plane a colour.
struct KnitPicture {
  std::vector<Grid<float>> planes;
  Mask mask;
  Extent extent;
};

/// largest_px  of a stitch in the small picture; blocks of pixels are averaged until it is as small
KnitPicture knit_picture(const Surface& surface, double stitch, double largest_px);

}  // namespace hada
