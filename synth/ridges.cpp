#include "synth/ridges.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

/// T(z) on a lattice, for millions of places: linear in between to 1e-6.
class TransportTable {
 public:
  explicit TransportTable(const HeightTransport& transport) {
    for (int i = 0; i <= 2 * reach * per_unit; ++i)
      values_.push_back(float(transport(double(i) / per_unit - reach)));
  }

  float operator()(float z) const {
    const float at = std::clamp((z + reach) * per_unit, 0.0f, 2.0f * reach * per_unit - 1.0f);
    const auto i = std::size_t(at);
    return values_[i] + (at - float(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr int reach = 8, per_unit = 512;
  std::vector<float> values_;
};

/// min over y of line(y) + (x - y)^2 / (2 radius) at every whole x.
class LineSharpener {
 public:
  explicit LineSharpener(double radius) : per_pixel2_(0.5 / radius), radius_(radius) {}

  void operator()(std::vector<float>& line) {
    const int n = int(line.size());
    vertices_.assign(line.size(), 0);
    from_.assign(line.size() + 1, 0.0);
    int k = 0;
    from_[0] = -HUGE_VAL;
    const auto crossing = [&](int right, int left) {
      return 0.5 * (right + left) +
             radius_ * (double(line[std::size_t(right)]) - line[std::size_t(left)]) /
                 (right - left);
    };
    for (int x = 1; x < n; ++x) {
      double at = crossing(x, vertices_[std::size_t(k)]);
      while (at <= from_[std::size_t(k)]) at = crossing(x, vertices_[std::size_t(--k)]);
      vertices_[std::size_t(++k)] = x;
      from_[std::size_t(k)] = at;
    }
    from_[std::size_t(k + 1)] = HUGE_VAL;
    lowest_.resize(line.size());
    k = 0;
    for (int x = 0; x < n; ++x) {
      while (from_[std::size_t(k + 1)] < x) ++k;
      lowest_[std::size_t(x)] = between(line, vertices_[std::size_t(k)], x);
    }
    line.swap(lowest_);
  }

 private:
  // The minimum lies between samples: through the best of them and its neighbours runs a parabola.
  float between(const std::vector<float>& line, int y, int x) const {
    const int last = int(line.size()) - 1;
    const double middle = line[std::size_t(y)];
    const double left = line[std::size_t(std::max(y - 1, 0))];
    const double right = line[std::size_t(std::min(y + 1, last))];
    const double slope = 0.5 * (right - left), bend = 0.5 * (left + right) - middle;
    const double away = x - y;
    const double steepness = 2.0 * (bend + per_pixel2_);
    const double step = steepness > 0.0
                            ? std::clamp((2.0 * per_pixel2_ * away - slope) / steepness, -1.0, 1.0)
                            : 0.0;
    const double cost =
        middle + step * (slope + bend * step) + per_pixel2_ * (away - step) * (away - step);
    return float(std::min(cost, middle + per_pixel2_ * away * away));
  }

  double per_pixel2_, radius_;
  std::vector<int> vertices_;
  std::vector<double> from_;
  std::vector<float> lowest_;
};

/// Lines that go on at their other end, for as far as anything is felt.
void sharpen_line(LineSharpener& sharpener, std::vector<float>& line, std::vector<float>& longer,
                  int margin) {
  if (margin == 0) return sharpener(line);
  const int n = int(line.size());
  longer.resize(line.size() + 2 * std::size_t(margin));
  for (int i = 0; i < int(longer.size()); ++i)
    longer[std::size_t(i)] = line[std::size_t(((i - margin) % n + n) % n)];
  sharpener(longer);
  std::copy_n(longer.begin() + margin, n, line.begin());
}

// The root mean square of the Laplacian: the fourth derivatives of the autocovariance at 0. Of what
// comes back, those of its kernel alone: only the unit of sharpness depends on it.
double mean_curvature(const Wrinkle<>& wrinkle) {
  double sum = 0.0;
  const auto add = [&](double amplitude, const GaussianCovariance<>& kernel) {
    const auto [variance, xx, xy, yy] = kernel;
    sum += amplitude * amplitude *
           (8.0 * (xx * xx + yy * yy + 2.0 * xy * xy) + 4.0 * (xx + yy) * (xx + yy));
  };
  for (const auto& component : wrinkle.components)
    add(component.amplitude_mm, autocovariance(component));
  for (const auto& noise : wrinkle.repeated) add(noise.amplitude_mm, autocovariance(noise).kernel);
  for (const auto& noise : wrinkle.woven) add(noise.amplitude_mm, autocovariance(noise).kernel);
  return std::sqrt(sum);
}

void centre(Grid<float>& map) {
  double sum = 0.0;
  for (const float value : map) sum += value;
  const float mean = float(sum / double(map.size()));
  for (float& value : map) value -= mean;
}

/// Sums over squares of (2 `reach` + 1)^2 ordinates; rows go on at the other side, columns end.
Grid<float> pooled(const Grid<float>& power, int reach) {
  Grid<float> along(power.rows(), power.cols());
  for_each_index(power.rows(), [&](int row) {
    for (int col = 0; col < power.cols(); ++col) {
      float sum = 0.0f;
      for (int k = -reach; k <= reach; ++k)
        sum += power(row, std::clamp(std::abs(col + k), 0, power.cols() - 1));
      along(row, col) = sum;
    }
  });
  Grid<float> both(power.rows(), power.cols());
  for_each_index(power.rows(), [&](int row) {
    for (int k = -reach; k <= reach; ++k) {
      const int from = ((row + k) % power.rows() + power.rows()) % power.rows();
      for (int col = 0; col < power.cols(); ++col) both(row, col) += along(from, col);
    }
  });
  return both;
}

Grid<float> powers(const Grid<std::complex<float>>& half) {
  Grid<float> power(half.rows(), half.cols());
  for (std::size_t i = 0; i < power.size(); ++i) power[i] = std::norm(half[i]);
  return power;
}

}  // namespace

HeightTransport::HeightTransport(double skew, double tail) : skew_(skew), stretch_(std::exp(tail)) {
  if (skew == 0.0 && tail == 0.0) return;
  double mass = 0.0, first = 0.0, second = 0.0;
  for (int i = -800; i <= 800; ++i) {  // the rule of trapezoids over a bell is exact to rounding
    const double z = 0.0125 * i;
    const double weight = std::exp(-0.5 * z * z), value = (*this)(z);
    mass += weight;
    first += weight * value;
    second += weight * value * value;
  }
  mean_ = first / mass;
  deviation_ = std::sqrt(second / mass - mean_ * mean_);
}

double HeightTransport::operator()(double z) const {
  return (std::sinh(stretch_ * std::asinh(z) + skew_) - mean_) / deviation_;
}

void sharpen(Grid<float>& height, double radius_px, bool tiles) {
  if (radius_px == 0.0 || height.empty()) return;
  const float sign = radius_px > 0.0 ? 1.0f : -1.0f;
  if (sign < 0.0f) {
    for (float& value : height) value = -value;
  }
  const double radius = std::abs(radius_px);
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  const double reach = std::sqrt(2.0 * radius * (double(*high) - *low)) + 2.0;
  const auto margin = [&](int n) { return tiles ? int(std::min(reach, double(n))) : 0; };
  for_slices(height.rows(), [&](int begin, int end) {
    LineSharpener sharpener(radius);
    std::vector<float> line, longer;
    for (int row = begin; row < end; ++row) {
      line.assign(&height(row, 0), &height(row, 0) + height.cols());
      sharpen_line(sharpener, line, longer, margin(height.cols()));
      std::copy(line.begin(), line.end(), &height(row, 0));
    }
  });
  for_slices(height.cols(), [&](int begin, int end) {
    LineSharpener sharpener(radius);
    std::vector<float> line(std::size_t(height.rows())), longer;
    for (int col = begin; col < end; ++col) {
      for (int row = 0; row < height.rows(); ++row) line[std::size_t(row)] = height(row, col);
      sharpen_line(sharpener, line, longer, margin(height.rows()));
      for (int row = 0; row < height.rows(); ++row)
        height(row, col) = sign * line[std::size_t(row)];
    }
  });
}

bool has_ridges(const Wrinkle<>& wrinkle) {
  return wrinkle.skew != 0.0 || wrinkle.tail != 0.0 || wrinkle.sharpness != 0.0;
}

double sharpening_radius(const Wrinkle<>& wrinkle) {
  return std::sinh(wrinkle.sharpness) / (8.0 * mean_curvature(wrinkle));
}

int felt_by_ridges(const Wrinkle<>& wrinkle, double pitch) {
  constexpr double most_range = 12.0;  // of heights, in standard deviations
  const double range = most_range * std::sqrt(variance_of(wrinkle));
  return int(std::sqrt(2.0 * std::abs(sharpening_radius(wrinkle)) * range) / pitch) + 2;
}

Grid<float> with_layers(Grid<float> field, const Wrinkle<>& wrinkle, double pitch, bool tiles) {
  if (wrinkle.skew != 0.0 || wrinkle.tail != 0.0) {
    const TransportTable transport{HeightTransport(wrinkle.skew, wrinkle.tail)};
    const float deviation = float(std::sqrt(variance_of(wrinkle)));
    for_each_index(field.rows(), [&](int row) {
      for (int col = 0; col < field.cols(); ++col)
        field(row, col) = deviation * transport(field(row, col) / deviation);
    });
  }
  sharpen(field, sharpening_radius(wrinkle) / (pitch * pitch), tiles);
  return field;
}

Grid<float> with_ridges(const Grid<float>& field, const Wrinkle<>& wrinkle, double pitch) {
  constexpr int reach = 2;  // 25 ordinates: enough to tell a gain from luck
  auto layered = with_layers(field, wrinkle, pitch, true);
  centre(layered);
  auto half = fft(layered);
  const auto wanted = pooled(powers(fft(field)), reach), made = pooled(powers(half), reach);
  for_each_index(half.rows(), [&](int row) {
    for (int col = 0; col < half.cols(); ++col) {
      const float power = made(row, col);
      half(row, col) *= power > 0.0f ? std::sqrt(wanted(row, col) / power) : 0.0f;
    }
  });
  return inverse_fft(std::move(half), field.cols());
}

}  // namespace hada
