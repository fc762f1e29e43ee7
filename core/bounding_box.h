#pragma once

#include "core/grid.h"

namespace hada {

/// A rectangle of pixels: `rows` x `cols` of them, the first at (row, col).
struct PixelBox {
  int row = 0;
  int col = 0;
  int rows = 0;
  int cols = 0;
};

/// The smallest rectangle that holds every pixel of `mask`, which must not be empty.
PixelBox bounding_box(const Mask& mask);

/// The rectangle of most pixels that are all in `mask`; the first of several, empty of an empty
/// one.
PixelBox largest_box_inside(const Mask& mask);

}  // namespace hada
