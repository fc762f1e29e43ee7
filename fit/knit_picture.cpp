#include "fit/knit_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace hada {

KnitPicture knit_picture(const Surface& surface, double stitch, double largest_px) {
  const int block = std::max(1, int(std::lround(stitch / surface.extent.pitch / largest_px)));
  KnitPicture picture;
  const int rows = surface.extent.rows / block, cols = surface.extent.cols / block;
  picture.extent = {rows, cols, surface.extent.pitch * block, surface.extent.unit};
  picture.mask = Mask(rows, cols, 1);
  // The blocks lie in the middle, so that the origin stays where it was, to half a pixel.
  const int top = (surface.extent.rows - rows * block) / 2;
  const int left = (surface.extent.cols - cols * block) / 2;
  for (const auto& plane : surface.albedo.planes) {
    Grid<float> small(rows, cols);
    for_each_index(rows, [&](int row) {
      for (int col = 0; col < cols; ++col) {
        float sum = 0.0f;
        for (int r = 0; r < block; ++r) {
          for (int c = 0; c < block; ++c) {
            const int y = top + row * block + r, x = left + col * block + c;
            if (!surface.mask(y, x)) picture.mask(row, col) = 0;
            sum += std::sqrt(std::max(0.0f, plane(y, x)));
          }
        }
        small(row, col) = sum / float(block * block);
      }
    });
    picture.planes.push_back(std::move(small));
  }
  return picture;
}

}  // namespace hada
