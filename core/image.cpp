#include "core/image.h"

namespace hada {

void luminance(const Image& image, int row, std::span<float> grey,
               const std::array<float, 3>& weight) {
  const auto first = image.planes[0].row(row);
  if (image.channels() < 3) {
    std::copy(first.begin(), first.end(), grey.begin());
    return;
  }
  const auto second = image.planes[1].row(row);
  const auto third = image.planes[2].row(row);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    float sum = 0.0f;
    sum += weight[0] * first[i];
    sum += weight[1] * second[i];
    sum += weight[2] * third[i];
    grey[i] = sum;
  }
}

Grid<float> luminance(const Image& image, const std::array<float, 3>& weight) {
  Grid<float> grey(image.rows(), image.cols(), 0.0f, image.memory());
  for_each_band(0, image.rows(), [&](int begin, int end) {
    for (int row = begin; row < end; ++row) luminance(image, row, grey.row(row), weight);
    image.let_go(begin, end);
    grey.let_go(begin, end);
  });
  return grey;
}

Image crop(const Image& image, int row, int col, int rows, int cols) {
  Image part;
  for (const auto& plane : image.planes) part.planes.push_back(crop(plane, row, col, rows, cols));
  return part;
}

}  // namespace hada
