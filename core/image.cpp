#include "core/image.h"

namespace hada {

Grid<float> luminance(const Image& image) {
  if (image.channels() < 3) return image.planes.front();
  Grid<float> grey(image.rows(), image.cols());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) grey[i] += luminance_weight[c] * image.planes[c][i];
  }
  return grey;
}

Image crop(const Image& image, int row, int col, int rows, int cols) {
  Image part;
  for (const auto& plane : image.planes) part.planes.push_back(crop(plane, row, col, rows, cols));
  return part;
}

}  // namespace hada
