#include "measure/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/bounding_box.h"
#include "core/error.h"
#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 8;  // along each side

/// Rises as a squared sine from 0 to 1 over `width`, and stays there.
double ease(double distance, double width) {
  if (distance >= width) return 1.0;
  const double s = std::sin(0.5 * std::numbers::pi * distance / width);
  return s * s;
}

std::vector<double> tukey(int count, double taper) {
  std::vector<double> window;
  for (int k = 0; k < count; ++k) {
    const double to_border = 0.5 + std::min(k, count - 1 - k);
    window.push_back(ease(to_border, 0.5 * taper * count));
  }
  return window;
}

/// Distance in pixels to the nearest pixel outside the mask; huge where there is none.
cv::Mat1f distance_inside(const Mask& mask) {
  const cv::Mat1b inside(mask.rows(), mask.cols(), const_cast<std::uint8_t*>(mask.data()));
  cv::Mat1f distance;
  cv::distanceTransform(inside != 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance;
}

Grid<double> taper_of(const Mask& mask, double taper) {
  const auto down = tukey(mask.rows(), taper);
  const auto across = tukey(mask.cols(), taper);
  Grid<double> weight(mask.rows(), mask.cols());
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      weight(row, col) = down[std::size_t(row)] * across[std::size_t(col)];
    }
  }
  if (std::all_of(mask.begin(), mask.end(), [](auto counts) { return counts != 0; })) return weight;

  // The same share of the way from the border to the middle as in the Tukey window.
  const cv::Mat1f distance = distance_inside(mask);
  double farthest = 0.0;
  cv::minMaxLoc(distance, nullptr, &farthest);
  const double width = taper * std::min(farthest, 0.5 * std::min(mask.rows(), mask.cols()));
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      weight(row, col) *=
          mask(row, col) ? ease(std::max(0.0, distance(row, col) - 0.5), width) : 0.0;
    }
  }
  return weight;
}

double sum_of(const Grid<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

Grid<double> times(const Grid<double>& a, const Grid<double>& b) {
  Grid<double> product(a.rows(), a.cols());
  for (std::size_t i = 0; i < product.size(); ++i) product[i] = a[i] * b[i];
  return product;
}

/// Sum of the squared steps from each value to the next one in direction (d_row, d_col), with
/// zeros around the grid.
double squared_steps(const Grid<double>& weight, int d_row, int d_col) {
  const auto at = [&](int row, int col) {
    return weight.contains(row, col) ? weight(row, col) : 0.0;
  };
  double sum = 0.0;
  for (int row = -d_row; row < weight.rows(); ++row) {
    for (int col = -d_col; col < weight.cols(); ++col) {
      const double step = at(row + d_row, col + d_col) - at(row, col);
      sum += step * step;
    }
  }
  return sum;
}

/// w (map - mean), the mean weighted so that nothing is left at frequency 0.
Grid<double> tapered(const Grid<float>& map, const Grid<double>& weight) {
  double sum = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (weight[i] > 0.0) sum += weight[i] * map[i];
  }
  const double mean = sum / sum_of(weight);
  Grid<double> product(map.rows(), map.cols());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (weight[i] > 0.0) product[i] = weight[i] * (map[i] - mean);
  }
  return product;
}

}  // namespace

double Spectrum::fx(int col) const {
  return signed_frequency(col, extent.cols) / extent.width();
}

double Spectrum::fy(int row) const {
  return -signed_frequency(row, extent.rows) / extent.height();  // rows run downward
}

Spectrum power_spectrum(const Grid<float>& map, const Mask& mask, const Extent& extent,
                        const SpectrumOptions& options) {
  assert(map.same_size(mask) && map.rows() == extent.rows && map.cols() == extent.cols);
  const PixelBox box = bounding_box(mask);
  if (box.rows < fewest_pixels || box.cols < fewest_pixels) {
    throw Error("spectrum: the mask is smaller than 8 x 8 pixels; measure a larger sample");
  }
  auto weight = taper_of(crop(mask, box.row, box.col, box.rows, box.cols), options.taper);
  const auto squared = times(weight, weight);
  const double sum_w2 = sum_of(squared);
  const double sum_w4 = sum_of(times(squared, squared));

  Spectrum spectrum;
  spectrum.extent = {box.rows, box.cols, extent.pitch, extent.unit};
  spectrum.independence = sum_w2 * sum_w2 / (double(weight.size()) * sum_w4);
  const double pitch2 = extent.pitch * extent.pitch;
  spectrum.window_x = squared_steps(weight, 0, 1) / (2.0 * sum_w2 * pitch2);
  spectrum.window_y = squared_steps(weight, 1, 0) / (2.0 * sum_w2 * pitch2);

  const auto half = fft(tapered(crop(map, box.row, box.col, box.rows, box.cols), weight));
  spectrum.power = Grid<double>(box.rows, box.cols);
  for_each_index(box.rows, [&](int row) {
    const int mirrored_row = (box.rows - row) % box.rows;
    for (int col = 0; col < box.cols; ++col) {
      const auto& value = col < half.cols() ? half(row, col) : half(mirrored_row, box.cols - col);
      spectrum.power(row, col) = std::norm(value) * pitch2 / sum_w2;
    }
  });
  spectrum.taper = std::move(weight);
  return spectrum;
}

}  // namespace hada
