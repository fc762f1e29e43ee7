#include "measure/line_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace hada {
namespace {

constexpr float inside_share = 0.98f;  // of a smoothing kernel: less, and the border shows
constexpr float least_share = 1e-3f;   // of a kernel: less, and there is nothing to smooth

/// OpenCV's view of a grid; nothing is copied.
cv::Mat1f view(const Grid<float>& grid) {
  return {grid.rows(), grid.cols(), const_cast<float*>(grid.data())};
}

Grid<float> blurred(const Grid<float>& grid, double sigma_px) {
  Grid<float> result(grid.rows(), grid.cols());
  cv::Mat1f out = view(result);
  cv::GaussianBlur(view(grid), out, {0, 0}, sigma_px, sigma_px, cv::BORDER_REFLECT_101);
  return result;
}

Grid<float> as_numbers(const Mask& mask) {
  Grid<float> numbers(mask.rows(), mask.cols());
  std::transform(mask.begin(), mask.end(), numbers.begin(),
                 [](std::uint8_t inside) { return inside ? 1.0f : 0.0f; });
  return numbers;
}

}  // namespace

Grid<float> smoothed(const Grid<float>& map, const Mask& mask, double sigma_px) {
  Grid<float> weighted(map.rows(), map.cols());
  for (std::size_t i = 0; i < map.size(); ++i) weighted[i] = mask[i] ? map[i] : 0.0f;
  Grid<float> sum = blurred(weighted, sigma_px);
  const Grid<float> share = blurred(as_numbers(mask), sigma_px);
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = share[i] > least_share ? sum[i] / share[i] : 0.0f;
  return sum;
}

LineField line_field(const Grid<float>& map, const Mask& mask, const LineFieldOptions& options) {
  const int rows = map.rows(), cols = map.cols();
  const Grid<float> smooth = smoothed(map, mask, options.gradient_px);
  const Grid<float> share = blurred(as_numbers(mask), options.gradient_px);
  Grid<float> xx(rows, cols), xy(rows, cols), yy(rows, cols);
  Mask known(rows, cols, 0);
  for (int row = 1; row + 1 < rows; ++row) {
    for (int col = 1; col + 1 < cols; ++col) {
      if (share(row, col) < inside_share) continue;
      const float gx = 0.5f * (smooth(row, col + 1) - smooth(row, col - 1));
      const float gy = 0.5f * (smooth(row - 1, col) - smooth(row + 1, col));
      xx(row, col) = gx * gx;
      xy(row, col) = gx * gy;
      yy(row, col) = gy * gy;
      known(row, col) = 1;
    }
  }
  xx = smoothed(xx, known, options.window_px);
  xy = smoothed(xy, known, options.window_px);
  yy = smoothed(yy, known, options.window_px);
  LineField field{Grid<float>(rows, cols), Grid<float>(rows, cols), Grid<float>(rows, cols)};
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double trace = double(xx[i]) + double(yy[i]);
    if (!known[i] || trace <= 0.0) continue;
    const double difference = double(xx[i]) - double(yy[i]);
    const double length = std::hypot(difference, 2.0 * double(xy[i]));
    const double angle = 0.5 * std::atan2(2.0 * double(xy[i]), difference);
    field.across[i] = float(angle < 0.0 ? angle + std::numbers::pi : angle);
    field.coherence[i] = float(length / trace);
    field.strength[i] = float(std::sqrt(trace));
  }
  return field;
}

}  // namespace hada
