#include "fit/grain_turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int reach = 12;                      // pixels on each side that make an interpolated one
constexpr double lowest = 2.5, highest = 0.3;  // frequencies that are mirrored: bins, cycles per px

constexpr double usual = 0.6, above_noise = 4.0;

using Weights = std::array<float, 2 * reach>;

/// Weights of the pixels 1 - reach to reach from one at the whole part of a place.
Weights sinc_weights(double part) {
  Weights weights;
  double sum = 0.0;
  for (int k = 0; k < 2 * reach; ++k) {
    const double x = k + 1 - reach - part;
    const double window = 0.5 + 0.5 * std::cos(pi * std::clamp(x / reach, -1.0, 1.0));
    const double value = std::abs(x) < 1e-9 ? 1.0 : std::sin(pi * x) / (pi * x) * window;
    weights[std::size_t(k)] = float(value);
    sum += value;
  }
  for (float& w : weights) w = float(w / sum);
  return weights;
}

/// Pixels of row `row` come from `slope` times the distance from the middle row further right.
Grid<float> sheared_along(const Grid<float>& from, double slope) {
  Grid<float> to(from.rows(), from.cols());
  for_each_index(from.rows(), [&](int row) {
    const double shift = slope * (0.5 * (from.rows() - 1) - row);
    const int whole = int(std::floor(shift));
    const Weights weights = sinc_weights(shift - whole);
    for (int col = 0; col < from.cols(); ++col) {
      float sum = 0.0f;
      for (int k = 0; k < 2 * reach; ++k) {
        const int at = std::clamp(col + whole + k + 1 - reach, 0, from.cols() - 1);
        sum += weights[std::size_t(k)] * from(row, at);
      }
      to(row, col) = sum;
    }
  });
  return to;
}

/// Pixels of column `col` come from `slope` times the distance from the middle column further up.
Grid<float> sheared_up(const Grid<float>& from, double slope) {
  Grid<float> to(from.rows(), from.cols());
  std::vector<int> whole;
  std::vector<Weights> weights;
  for (int col = 0; col < from.cols(); ++col) {
    const double shift = -slope * (col - 0.5 * (from.cols() - 1));  // rows count downwards
    whole.push_back(int(std::floor(shift)));
    weights.push_back(sinc_weights(shift - whole.back()));
  }
  for_each_index(from.rows(), [&](int row) {
    for (int col = 0; col < from.cols(); ++col) {
      float sum = 0.0f;
      for (int k = 0; k < 2 * reach; ++k) {
        const int at =
            std::clamp(row + whole[std::size_t(col)] + k + 1 - reach, 0, from.rows() - 1);
        sum += weights[std::size_t(col)][std::size_t(k)] * from(at, col);
      }
      to(row, col) = sum;
    }
  });
  return to;
}

/// Logarithms of a periodogram, each of the mean of three by three ordinates; of what lies well
/// above the power that most of the ordinates have, so that noise has no say.
class LogPower {
 public:
  explicit LogPower(const Grid<float>& scores)
      : rows_(scores.rows()), cols_(scores.cols()), log_(rows_, cols_ / 2 + 1) {
    Grid<double> tapered(rows_, cols_);
    const auto hann = [](int k, int n) { return 0.5 - 0.5 * std::cos(2.0 * pi * (k + 0.5) / n); };
    for_each_index(rows_, [&](int row) {
      for (int col = 0; col < cols_; ++col)
        tapered(row, col) = scores(row, col) * hann(row, rows_) * hann(col, cols_);
    });
    const auto half = fft(tapered);
    const auto power = [&](int i, int j) {
      if (j < 0) i = -i, j = -j;
      if (j >= half.cols()) i = -i, j = cols_ - j;
      return std::norm(half((i + 2 * rows_) % rows_, j));
    };
    for_each_index(rows_, [&](int i) {
      for (int j = 0; j < half.cols(); ++j) {
        double sum = 0.0;
        for (int di = -1; di <= 1; ++di) {
          for (int dj = -1; dj <= 1; ++dj) sum += power(i + di, j + dj);
        }
        log_(i, j) = float(sum);
      }
    });
    std::vector<float> inside;
    for (int i = -int(highest * rows_); i <= int(highest * rows_); ++i) {
      for (int j = 0; j <= int(highest * cols_); ++j) inside.push_back(at(i, j));
    }
    const double noise = above_noise * std::max(double(quantile(inside, usual)), 1e-30);
    for (float& value : log_) value = float(std::log1p(value / noise));
  }

  /// Mean square difference between the logarithms and their mirror image.
  double unlike(double axis_rad) const {
    const double c = std::cos(2.0 * axis_rad), s = std::sin(2.0 * axis_rad);
    double sum = 0.0;
    int count = 0;
    const int most_i = int(highest * rows_), most_j = int(highest * cols_);
    for (int i = -most_i; i <= most_i; ++i) {
      for (int j = 0; j <= most_j; ++j) {
        if (std::hypot(i, j) < lowest) continue;
        // Rows of the transform count frequencies that run downwards.
        const double fx = double(j) / cols_, fy = -double(i) / rows_;
        const double difference =
            at(-(s * fx - c * fy) * rows_, (c * fx + s * fy) * cols_) - at(i, j);
        sum += difference * difference;
        ++count;
      }
    }
    return sum / count;
  }

 private:
  float at(int i, int j) const { return log_((i + rows_) % rows_, j); }
  double at(double i, double j) const {
    if (j < 0.0) i = -i, j = -j;
    const double i0 = std::floor(i), j0 = std::floor(j), a = i - i0, b = j - j0;
    const int r = int(i0), c = int(j0);
    return (1 - a) * ((1 - b) * at(r, c) + b * at(r, c + 1)) +
           a * ((1 - b) * at(r + 1, c) + b * at(r + 1, c + 1));
  }

  int rows_, cols_;
  Grid<float> log_;
};

}  // namespace

double mirror_axis(const Grid<float>& scores, const MirrorOptions& options) {
  const LogPower power(scores);
  const int steps = int(std::ceil(options.most_rad / options.step_rad));
  std::vector<double> unlike(std::size_t(2 * steps + 1));
  for_each_index(int(unlike.size()), [&](int k) {
    unlike[std::size_t(k)] = power.unlike((k - steps) * options.step_rad);
  });
  const auto best = int(std::min_element(unlike.begin(), unlike.end()) - unlike.begin());
  double peak = 0.0;
  if (best > 0 && best + 1 < int(unlike.size())) {
    const double before = unlike[std::size_t(best - 1)], here = unlike[std::size_t(best)];
    const double after = unlike[std::size_t(best + 1)], bend = before - 2.0 * here + after;
    if (bend > 0.0) peak = std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
  }
  return (best + peak - steps) * options.step_rad;
}

Grid<float> turned_back(const Grid<float>& picture, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(std::abs(angle_rad));
  const double w = picture.cols() - 2 * reach, h = picture.rows() - 2 * reach;
  const int cols = int((w * c - h * s) / (c * c - s * s));
  const int rows = int((h * c - w * s) / (c * c - s * s));
  if (cols <= 0 || rows <= 0) return {};
  const double half = -std::tan(0.5 * angle_rad);
  const auto level =
      sheared_along(sheared_up(sheared_along(picture, half), std::sin(angle_rad)), half);
  return crop(level, (picture.rows() - rows) / 2, (picture.cols() - cols) / 2, rows, cols);
}

}  // namespace hada
