#include "measure/line_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace hada {
namespace {

constexpr float inside_share = 0.98f;  // of a smoothing kernel: less, and the border shows
constexpr float least_share = 1e-3f;   // of a kernel: less, and there is nothing to smooth

/// OpenCV's view of a grid; nothing is copied.
cv::Mat1f view(const Grid<float>& grid) {
  return {grid.rows(), grid.cols(), const_cast<float*>(grid.data())};
}

Grid<float> blurred(Grid<float> grid, double sigma_px) {
  cv::Mat1f in_place = view(grid);
  cv::GaussianBlur(in_place, in_place, {0, 0}, sigma_px, sigma_px, cv::BORDER_REFLECT_101);
  return grid;
}

Grid<float> as_numbers(const Mask& mask) {
  Grid<float> numbers(mask.rows(), mask.cols());
  std::transform(mask.begin(), mask.end(), numbers.begin(),
                 [](std::uint8_t inside) { return inside ? 1.0f : 0.0f; });
  return numbers;
}

/// A Gaussian that does not look outside a mask.
class MaskedBlur {
 public:
  MaskedBlur(const Mask& mask, double sigma_px)
      : share_(blurred(as_numbers(mask), sigma_px)), sigma_px_(sigma_px) {}

  /// How much of the kernel lies inside.
  const Grid<float>& share() const { return share_; }

  /// `map`, which is 0 outside the mask, smoothed; 0 where the mask is not near.
  Grid<float> operator()(Grid<float> map) const {
    map = blurred(std::move(map), sigma_px_);
    for (std::size_t i = 0; i < map.size(); ++i)
      map[i] = share_[i] > least_share ? map[i] / share_[i] : 0.0f;
    return map;
  }

 private:
  Grid<float> share_;
  double sigma_px_;
};

Grid<float> inside(const Grid<float>& map, const Mask& mask) {
  Grid<float> result(map.rows(), map.cols());
  for (std::size_t i = 0; i < map.size(); ++i) result[i] = mask[i] ? map[i] : 0.0f;
  return result;
}

double difference(const LineField& field, int row, int col) {
  return double(field.xx(row, col)) - double(field.yy(row, col));
}

double trace(const LineField& field, int row, int col) {
  return double(field.xx(row, col)) + double(field.yy(row, col));
}

}  // namespace

float LineField::across(int row, int col) const {
  const double angle = 0.5 * std::atan2(2.0 * double(xy(row, col)), difference(*this, row, col));
  return float(angle < 0.0 ? angle + std::numbers::pi : angle);
}

float LineField::coherence(int row, int col) const {
  const double all = trace(*this, row, col);
  if (all <= 0.0) return 0.0f;
  return float(std::hypot(difference(*this, row, col), 2.0 * double(xy(row, col))) / all);
}

float LineField::strength(int row, int col) const {
  return float(std::sqrt(std::max(trace(*this, row, col), 0.0)));
}

Grid<float> smoothed(const Grid<float>& map, const Mask& mask, double sigma_px) {
  return MaskedBlur(mask, sigma_px)(inside(map, mask));
}

LineField line_field(const Grid<float>& map, const Mask& mask, const LineFieldOptions& options) {
  const int rows = map.rows(), cols = map.cols();
  LineField field{Grid<float>(rows, cols), Grid<float>(rows, cols), Grid<float>(rows, cols)};
  Mask known(rows, cols, 0);
  {
    const MaskedBlur blur(mask, options.gradient_px);
    const Grid<float> smooth = blur(inside(map, mask));
    for (int row = 1; row + 1 < rows; ++row) {
      for (int col = 1; col + 1 < cols; ++col) {
        if (blur.share()(row, col) < inside_share) continue;
        const float gx = 0.5f * (smooth(row, col + 1) - smooth(row, col - 1));
        const float gy = 0.5f * (smooth(row - 1, col) - smooth(row + 1, col));
        field.xx(row, col) = gx * gx;
        field.xy(row, col) = gx * gy;
        field.yy(row, col) = gy * gy;
        known(row, col) = 1;
      }
    }
  }
  const MaskedBlur gather(known, options.window_px);
  for (Grid<float>* part : {&field.xx, &field.xy, &field.yy})
    *part = inside(gather(std::move(*part)), known);
  return field;
}

}  // namespace hada
