#include "core/bounding_box.h"

#include <algorithm>

namespace hada {

PixelBox bounding_box(const Mask& mask) {
  int top = mask.rows();
  int left = mask.cols();
  int bottom = -1;
  int right = -1;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      top = std::min(top, row);
      bottom = row;
      left = std::min(left, col);
      right = std::max(right, col);
    }
  }
  return {top, left, bottom - top + 1, right - left + 1};
}

}  // namespace hada
