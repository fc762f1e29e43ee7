#include "core/bounding_box.h"

#include <algorithm>
#include <cstddef>
#include <vector>

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

PixelBox largest_box_inside(const Mask& mask) {
  PixelBox largest;
  std::vector<int> above(std::size_t(mask.cols()) + 1, 0);  // pixels in one piece, up from this row
  for (int row = 0; row < mask.rows(); ++row) {
    std::vector<int> risen;  // columns at which a box as high as there may begin, ever higher
    for (int col = 0; col <= mask.cols(); ++col) {
      int& here = above[std::size_t(col)];  // beyond the last column nothing stands: all boxes end
      here = col < mask.cols() && mask(row, col) ? here + 1 : 0;
      while (!risen.empty() && above[std::size_t(risen.back())] >= here) {
        const int height = above[std::size_t(risen.back())];
        risen.pop_back();
        const int left = risen.empty() ? 0 : risen.back() + 1;
        if (std::size_t(height) * std::size_t(col - left) >
            std::size_t(largest.rows) * std::size_t(largest.cols)) {
          largest = {row - height + 1, left, height, col - left};
        }
      }
      risen.push_back(col);
    }
  }
  return largest;
}

}  // namespace hada
