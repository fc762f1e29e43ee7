#include "measure/autocorrelation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double fallen = 0.2;          // where it counts as gone (ISO 25178-3)
constexpr double least_overlap = 0.25;  // of the pixels, for a lag to be believed
constexpr double march_step_px = 0.25;

Grid<float> correlated_with_itself(const Grid<float>& map) {
  auto half = fft(map);
  for (auto& value : half) value = std::norm(value);
  return inverse_fft(std::move(half), map.cols());
}

struct Moments {
  double mean;
  double variance;
};

Moments moments(const Grid<float>& height, const Mask& mask) {
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    count += 1.0;
    sum += height[i];
  }
  const double mean = sum / count;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) squares += (height[i] - mean) * (height[i] - mean);
  }
  return {mean, squares / count};
}

}  // namespace

Autocorrelation::Autocorrelation(const Grid<float>& height, const Mask& mask)
    : most_rows_(height.rows() / 2),
      most_cols_(height.cols() / 2),
      rows_(height.rows()),
      cols_(height.cols()) {
  const auto [mean, variance] = moments(height, mask);
  // A lag and what comes around from the other side share no product.
  const int rows = fast_length(rows_ + most_rows_);
  const int cols = fast_length(cols_ + most_cols_);
  const bool is_full = std::all_of(mask.begin(), mask.end(), [](auto counts) { return counts; });
  Grid<float> map(rows, cols);
  for (int row = 0; row < rows_; ++row) {
    for (int col = 0; col < cols_; ++col) {
      if (mask(row, col)) map(row, col) = float((height(row, col) - mean) / std::sqrt(variance));
    }
  }
  products_ = correlated_with_itself(map);
  if (!is_full) {
    Grid<float> inside(rows, cols);
    for (int row = 0; row < rows_; ++row) {
      for (int col = 0; col < cols_; ++col) inside(row, col) = mask(row, col) ? 1.0f : 0.0f;
    }
    pairs_ = correlated_with_itself(inside);
  }
  fewest_pairs_ = least_overlap * pairs(0, 0);
}

std::optional<double> Autocorrelation::at(double right, double down) const {
  const int row = int(std::floor(down));
  const int col = int(std::floor(right));
  const double v = down - row;
  const double u = right - col;
  const auto upper_left = at_lag(row, col), upper_right = at_lag(row, col + 1);
  const auto lower_left = at_lag(row + 1, col), lower_right = at_lag(row + 1, col + 1);
  if (!upper_left || !upper_right || !lower_left || !lower_right) return std::nullopt;
  return (1 - v) * ((1 - u) * *upper_left + u * *upper_right) +
         v * ((1 - u) * *lower_left + u * *lower_right);
}

double Autocorrelation::length_px(double right, double down) const {
  double last = 1.0;
  for (double lag = march_step_px;; lag += march_step_px) {
    const auto value = at(lag * right, lag * down);
    if (!value) return lag - march_step_px;
    if (*value < fallen) return lag - march_step_px * (fallen - *value) / (last - *value);
    last = *value;
  }
}

std::vector<double> Autocorrelation::lengths_px(int directions) const {
  std::vector<double> lengths(static_cast<std::size_t>(directions));
  for_each_index(directions, [&](int i) {
    const double angle = std::numbers::pi * i / directions;
    // Rows run downward. Lags come in pairs of opposite signs, so that either sign would do.
    lengths[std::size_t(i)] = length_px(std::cos(angle), -std::sin(angle));
  });
  return lengths;
}

std::optional<double> Autocorrelation::at_lag(int row, int col) const {
  if (std::abs(row) > most_rows_ || std::abs(col) > most_cols_) return std::nullopt;
  const int r = (row + products_.rows()) % products_.rows();
  const int c = (col + products_.cols()) % products_.cols();
  const double count = pairs(row, col);
  if (count < fewest_pairs_) return std::nullopt;
  return double(products_(r, c)) / count;
}

double Autocorrelation::pairs(int row, int col) const {
  if (pairs_.empty()) return double(rows_ - std::abs(row)) * (cols_ - std::abs(col));
  return pairs_((row + pairs_.rows()) % pairs_.rows(), (col + pairs_.cols()) % pairs_.cols());
}

}  // namespace hada
