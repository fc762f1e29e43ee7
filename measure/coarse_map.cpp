#include "measure/coarse_map.h"

#include <algorithm>
#include <cstddef>

namespace hada {
namespace {

constexpr int steps_across = 128;  // the longer side
constexpr int fewest_steps = 16;   // over the shorter side

}  // namespace

CoarseMap coarse_map(const Grid<float>& map, const Mask& mask, double pitch) {
  const PixelBox box = bounding_box(mask);
  const int longer = std::max(box.rows, box.cols), shorter = std::min(box.rows, box.cols);
  const int block =
      std::max(1, std::min((longer + steps_across - 1) / steps_across, shorter / fewest_steps));
  const int rows = (box.rows + block - 1) / block, cols = (box.cols + block - 1) / block;
  CoarseMap coarse{box, block, Grid<double>(rows, cols), Mask(rows, cols, 0), block * pitch};
  double sum = 0.0, count = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      double inside = 0.0, pixels = 0.0;
      for (int y = row * block; y < std::min((row + 1) * block, box.rows); ++y) {
        for (int x = col * block; x < std::min((col + 1) * block, box.cols); ++x) {
          if (!mask(box.row + y, box.col + x)) continue;
          inside += map(box.row + y, box.col + x);
          pixels += 1.0;
        }
      }
      if (2.0 * pixels < double(block) * block) continue;
      coarse.mask(row, col) = 1;
      coarse.height(row, col) = inside / pixels;
      sum += coarse.height(row, col);
      count += 1.0;
    }
  }
  for (std::size_t i = 0; i < coarse.mask.size(); ++i) {
    if (!coarse.mask[i]) continue;
    coarse.height[i] -= sum / count;
    coarse.variance += coarse.height[i] * coarse.height[i] / count;
  }
  return coarse;
}

}  // namespace hada
