#include "measure/roughness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 64;
constexpr float fallen = 0.2f;          // where the autocorrelation counts as gone (ISO 25178-3)
constexpr double least_overlap = 0.25;  // of the pixels, for a lag to be believed
constexpr int directions = 180;         // in half a turn
constexpr double march_step_px = 0.25;

// Sums that are formed for each row and added up in row order.
template <std::size_t n, class Work>
std::array<double, n> sums_of_rows(int rows, const Work& work) {
  std::vector<std::array<double, n>> sums(std::size_t(rows), std::array<double, n>{});
  for_each_index(rows, [&](int row) { work(row, sums[std::size_t(row)]); });
  std::array<double, n> total{};
  for (const auto& sum : sums) {
    for (std::size_t i = 0; i < n; ++i) total[i] += sum[i];
  }
  return total;
}

void measure_heights(const Grid<float>& height, const Mask& mask, double mean, Roughness& found) {
  double highest = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    highest = std::max(highest, double(height[i]));
    lowest = std::min(lowest, double(height[i]));
  }
  const auto sums = sums_of_rows<5>(height.rows(), [&](int row, auto& sum) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      const double z = height(row, col) - mean;
      sum[0] += 1.0;
      sum[1] += std::abs(z);
      sum[2] += z * z;
      sum[3] += z * z * z;
      sum[4] += z * z * z * z;
    }
  });
  found.Sp = highest - mean;
  found.Sv = mean - lowest;
  found.Sz = highest - lowest;
  found.Sa = sums[1] / sums[0];
  found.Sq = std::sqrt(sums[2] / sums[0]);
  if (found.Sq == 0.0) return;
  found.Ssk = sums[3] / sums[0] / std::pow(found.Sq, 3.0);
  found.Sku = sums[4] / sums[0] / std::pow(found.Sq, 4.0);
}

// Over every square of four pixels of the mask: the slopes along its four edges give its two times
// two triangles, and its mean slope the direction of the lay.
void measure_slopes(const Grid<float>& height, const Mask& mask, double pitch, Roughness& found) {
  const auto sums = sums_of_rows<5>(std::max(height.rows() - 1, 0), [&](int row, auto& sum) {
    for (int col = 0; col + 1 < height.cols(); ++col) {
      if (!mask(row, col) || !mask(row, col + 1) || !mask(row + 1, col) ||
          !mask(row + 1, col + 1)) {
        continue;
      }
      const double top = (height(row, col + 1) - height(row, col)) / pitch;
      const double bottom = (height(row + 1, col + 1) - height(row + 1, col)) / pitch;
      const double left = (height(row, col) - height(row + 1, col)) / pitch;  // y runs upward
      const double right = (height(row, col + 1) - height(row + 1, col + 1)) / pitch;
      sum[0] += 1.0;
      sum[1] += 0.5 * (top * top + bottom * bottom + left * left + right * right);
      for (const double dx : {top, bottom}) {
        for (const double dy : {left, right}) {
          sum[2] += 0.25 * (std::sqrt(1.0 + dx * dx + dy * dy) - 1.0);
        }
      }
      const double dx = 0.5 * (top + bottom);
      const double dy = 0.5 * (left + right);
      sum[3] += dx * dx - dy * dy;
      sum[4] += 2.0 * dx * dy;
    }
  });
  if (sums[0] == 0.0) return;
  found.Sdq = std::sqrt(sums[1] / sums[0]);
  found.Sdr = sums[2] / sums[0];
  // The lay runs across the steepest direction, the long axis of the covariance of the slopes.
  const double steepest = 0.5 * std::atan2(sums[4], sums[3]);
  const double lay = std::fmod(steepest + 1.5 * std::numbers::pi, std::numbers::pi);
  found.Std = lay;
}

// The next length whose transform is fast: no prime factor above 5.
int fast_length(int least) {
  for (int length = least;; ++length) {
    int rest = length;
    for (const int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return length;
  }
}

Grid<float> correlated_with_itself(const Grid<float>& map) {
  auto half = fft(map);
  for (auto& value : half) value = std::norm(value);
  return inverse_fft(half, map.cols());
}

// The autocorrelation at lags up to half of each side: products of pairs over their number.
class Autocorrelation {
 public:
  Autocorrelation(const Grid<float>& height, const Mask& mask, double mean, double variance)
      : most_rows_(height.rows() / 2), most_cols_(height.cols() / 2) {
    const int rows = fast_length(height.rows() + most_rows_ + 1);
    const int cols = fast_length(height.cols() + most_cols_ + 1);
    Grid<float> map(rows, cols);
    Grid<float> inside(rows, cols);
    for (int row = 0; row < height.rows(); ++row) {
      for (int col = 0; col < height.cols(); ++col) {
        if (!mask(row, col)) continue;
        map(row, col) = float((height(row, col) - mean) / std::sqrt(variance));
        inside(row, col) = 1.0f;
      }
    }
    products_ = correlated_with_itself(map);
    pairs_ = correlated_with_itself(inside);
    fewest_pairs_ = least_overlap * pairs_(0, 0);
  }

  // The first lag (px) along the direction (right, down) at which it has fallen; the last lag that
  // can be believed where it never does.
  double length_px(double right, double down) const {
    double last = 1.0;
    for (double lag = march_step_px;; lag += march_step_px) {
      const auto value = at(lag * down, lag * right);
      if (!value) return lag - march_step_px;
      if (*value < fallen) return lag - march_step_px * (fallen - *value) / (last - *value);
      last = *value;
    }
  }

 private:
  std::optional<double> at(double row, double col) const {
    const int r = int(std::floor(row));
    const int c = int(std::floor(col));
    const double v = row - r;
    const double u = col - c;
    const auto upper_left = at_lag(r, c), upper_right = at_lag(r, c + 1);
    const auto lower_left = at_lag(r + 1, c), lower_right = at_lag(r + 1, c + 1);
    if (!upper_left || !upper_right || !lower_left || !lower_right) return std::nullopt;
    return (1 - v) * ((1 - u) * *upper_left + u * *upper_right) +
           v * ((1 - u) * *lower_left + u * *lower_right);
  }
  std::optional<double> at_lag(int row, int col) const {
    if (std::abs(row) > most_rows_ || std::abs(col) > most_cols_) return std::nullopt;
    const int r = row < 0 ? row + products_.rows() : row;
    const int c = col < 0 ? col + products_.cols() : col;
    if (pairs_(r, c) < fewest_pairs_) return std::nullopt;
    return double(products_(r, c)) / pairs_(r, c);
  }

  int most_rows_;
  int most_cols_;
  double fewest_pairs_ = 0.0;
  Grid<float> products_;
  Grid<float> pairs_;
};

void measure_texture(const Grid<float>& height, const Mask& mask, double mean, double pitch,
                     Roughness& found) {
  const Autocorrelation autocorrelation(height, mask, mean, found.Sq * found.Sq);
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (int i = 0; i < directions; ++i) {
    const double angle = std::numbers::pi * i / directions;
    const double length = autocorrelation.length_px(std::cos(angle), std::sin(angle));
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  found.Sal = shortest * pitch;
  found.Str = longest > 0.0 ? shortest / longest : 0.0;
}

}  // namespace

Roughness roughness(const Grid<float>& height, const Mask& mask, double pitch) {
  const auto [count, sum] = sums_of_rows<2>(height.rows(), [&](int row, auto& sums) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      sums[0] += 1.0;
      sums[1] += height(row, col);
    }
  });
  if (count < fewest_pixels) {
    throw Error("the mask holds " + std::to_string(int(count)) +
                " pixels, roughness needs at least " + std::to_string(fewest_pixels) +
                ": measure a larger piece");
  }
  const double mean = sum / count;
  Roughness found;
  measure_heights(height, mask, mean, found);
  if (found.Sq == 0.0) return found;  // a mirror: no skewness, slope or texture to speak of
  measure_slopes(height, mask, pitch, found);
  measure_texture(height, mask, mean, pitch, found);
  return found;
}

}  // namespace hada
