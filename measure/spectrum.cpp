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
#include "measure/small_holes.h"

namespace hada {
namespace {

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
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      weight(row, col) = down[std::size_t(row)] * across[std::size_t(col)];
    }
  });
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

/// What a taper costs.
struct TaperSums {
  double squares = 0.0, fourth_powers = 0.0;
  double steps_x = 0.0, steps_y = 0.0;  // squared steps to the next value, with zeros all around
};

TaperSums sums_of_row(const Grid<double>& weight, int row) {
  const auto here = weight.row(row);
  TaperSums sums;
  double left = 0.0;
  for (std::size_t col = 0; col < here.size(); ++col) {
    const double w = here[col], w2 = w * w;
    const double below = row + 1 < weight.rows() ? weight(row + 1, int(col)) : 0.0;
    sums.squares += w2;
    sums.fourth_powers += w2 * w2;
    sums.steps_x += (w - left) * (w - left);
    sums.steps_y += (w - below) * (w - below);
    if (row == 0) sums.steps_y += w2;
    left = w;
  }
  sums.steps_x += left * left;
  return sums;
}

TaperSums sums_of(const Grid<double>& weight) {
  std::vector<TaperSums> of_rows(std::size_t(weight.rows()));
  for_each_index(weight.rows(),
                 [&](int row) { of_rows[std::size_t(row)] = sums_of_row(weight, row); });
  TaperSums sums;
  for (const TaperSums& row : of_rows) {
    for (const auto member :
         {&TaperSums::squares, &TaperSums::fourth_powers, &TaperSums::steps_x, &TaperSums::steps_y})
      sums.*member += row.*member;
  }
  return sums;
}

}  // namespace

double Spectrum::fx(int col) const {
  return signed_frequency(col, extent.cols) / extent.width();
}

double Spectrum::fy(int row) const {
  return -signed_frequency(row, extent.rows) / extent.height();  // rows run downward
}

Grid<double> tapered(const Grid<float>& map, const PixelBox& box, const Grid<double>& taper) {
  assert(taper.rows() == box.rows && taper.cols() == box.cols);
  double sum = 0.0, weights = 0.0;
  for (int row = 0; row < box.rows; ++row) {
    for (int col = 0; col < box.cols; ++col) {
      const double w = taper(row, col);
      if (!(w > 0.0)) continue;
      sum += w * map(box.row + row, box.col + col);
      weights += w;
    }
  }
  const double mean = sum / weights;
  Grid<double> product(box.rows, box.cols);
  for_each_index(box.rows, [&](int row) {
    for (int col = 0; col < box.cols; ++col) {
      const double w = taper(row, col);
      if (w > 0.0) product(row, col) = w * (map(box.row + row, box.col + col) - mean);
    }
  });
  return product;
}

Spectrum power_spectrum(const Grid<float>& torn_map, const Mask& torn_mask, const Extent& extent,
                        const SpectrumOptions& options) {
  assert(torn_map.same_size(torn_mask));
  assert(torn_map.rows() == extent.rows && torn_map.cols() == extent.cols);
  const auto filled = without_small_holes(torn_map, torn_mask);
  const Grid<float>& map = filled ? filled->map : torn_map;
  const Mask& mask = filled ? filled->mask : torn_mask;
  const PixelBox box = bounding_box(mask);
  if (std::min(box.rows, box.cols) < fewest_spectrum_pixels) {
    throw Error("spectrum: the mask is smaller than 8 x 8 pixels; measure a larger sample");
  }
  auto weight = taper_of(crop(mask, box.row, box.col, box.rows, box.cols), options.taper);
  const TaperSums sums = sums_of(weight);

  Spectrum spectrum;
  spectrum.extent = {box.rows, box.cols, extent.pitch, extent.unit};
  spectrum.independence =
      sums.squares * sums.squares / (double(weight.size()) * sums.fourth_powers);
  const double pitch2 = extent.pitch * extent.pitch;
  spectrum.window_x = sums.steps_x / (2.0 * sums.squares * pitch2);
  spectrum.window_y = sums.steps_y / (2.0 * sums.squares * pitch2);

  const auto half = fft(tapered(map, box, weight));
  spectrum.power = Grid<double>(box.rows, box.cols);
  for_each_index(box.rows, [&](int row) {
    const int mirrored_row = (box.rows - row) % box.rows;
    for (int col = 0; col < box.cols; ++col) {
      const auto& value = col < half.cols() ? half(row, col) : half(mirrored_row, box.cols - col);
      spectrum.power(row, col) = std::norm(value) * pitch2 / sums.squares;
    }
  });
  spectrum.taper = std::move(weight);
  return spectrum;
}

}  // namespace hada
