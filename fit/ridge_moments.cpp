#include "fit/ridge_moments.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double tau = 2.0 * std::numbers::pi;
constexpr int most_smoothings = 64;

// One pass of 1 2 1 along both axes; the mask loses its outermost pixels.
void smooth(Grid<float>& map, Mask& mask) {
  Grid<float> smoother(map.rows(), map.cols());
  Mask inner(map.rows(), map.cols());
  for_each_index(map.rows(), [&](int row) {
    if (row == 0 || row + 1 == map.rows()) return;
    for (int col = 1; col + 1 < map.cols(); ++col) {
      float sum = 0.0f;
      bool whole = true;
      for (int i = -1; i <= 1; ++i) {
        for (int k = -1; k <= 1; ++k) {
          whole = whole && mask(row + i, col + k);
          sum += float((2 - std::abs(i)) * (2 - std::abs(k))) * map(row + i, col + k);
        }
      }
      if (!whole) continue;
      inner(row, col) = 1;
      smoother(row, col) = sum / 16.0f;
    }
  });
  map = std::move(smoother);
  mask = std::move(inner);
}

void standardise(std::vector<float>& values) {
  double sum = 0.0, squares = 0.0;
  for (const float value : values) sum += value;
  const double n = double(std::max(values.size(), std::size_t(1))), mean = sum / n;
  for (const float value : values) squares += (value - mean) * (value - mean);
  const double scale = squares > 0.0 ? std::sqrt(n / squares) : 0.0;
  for (float& value : values) value = float((value - mean) * scale);
}

struct Shape {
  double skewness = 0.0, kurtosis = 0.0;
};

Shape shape_of(const std::vector<float>& standard) {
  Shape shape;
  const double n = double(standard.size());
  for (const float value : standard) {
    const double square = double(value) * value;
    shape.skewness += square * value;
    shape.kurtosis += square * square;
  }
  return {shape.skewness / n, shape.kurtosis / n};
}

double tail_of(double kurtosis) {
  return std::log(std::max(kurtosis, 1.0) / 3.0);  // no kurtosis is less than 1
}

/// What differences and smoothing leave of a wave, in the order height, slopes, curvature; in
/// pixels.
std::array<std::complex<double>, 4> responses(double x, double y, int smoothings) {
  const double cx = std::cos(tau * x), cy = std::cos(tau * y);
  const double left = std::pow(0.25 * (1.0 + cx) * (1.0 + cy), smoothings);
  return {left, std::complex<double>(0.0, left * std::sin(tau * x)),
          std::complex<double>(0.0, left * std::sin(tau * y)), left * (2.0 * cx + 2.0 * cy - 4.0)};
}

/// Shares of the power of the curvature: of the noise functions and of the floor.
std::array<double, 2> curvature_power(const Wrinkle<>& wrinkle, double pitch, int smoothings) {
  constexpr int n = 96;
  Wrinkle<> bare = wrinkle;
  bare.floor_mm4 = 0.0;
  const auto density = spectrum_of(bare);
  std::array<double, 2> power{};
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      // Finer steps towards frequency 0, where noise functions as large as the map have their
      // power.
      const auto at = [&](int j) { return 0.5 * std::pow((j + 0.5) / n, 2); };
      const double width = (i + 0.5) * (k + 0.5);
      for (const double sign : {1.0, -1.0}) {
        const double x = at(i), y = sign * at(k);
        const double left = width * std::norm(responses(x, y, smoothings)[3]);
        power[0] += left * density(x / pitch, y / pitch);
        power[1] += left * wrinkle.floor_mm4;
      }
    }
  }
  return power;
}

using Amplitudes = std::array<Grid<std::complex<double>>, 4>;

/// How alike the four fields are at every lag.
class CrossCorrelations {
 public:
  CrossCorrelations(const Amplitudes& amplitudes, int cols) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        Grid<std::complex<double>> product(amplitudes[i].rows(), amplitudes[i].cols());
        for (std::size_t at = 0; at < product.size(); ++at)
          product[at] = amplitudes[i][at] * std::conj(amplitudes[k][at]);
        at_lag_[i][k] = inverse_fft(std::move(product), cols);
      }
    }
    std::array<double, 4> deviation;
    for (std::size_t i = 0; i < 4; ++i)
      deviation[i] = std::sqrt(std::max(at_lag_[i][i][0], 1e-300));
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (double& value : at_lag_[i][k]) value /= deviation[i] * deviation[k];
      }
    }
  }

  /// Over all lags, the sum of the permanents of the matrix with row i for `a[i]`, column k for
  /// `b[k]`.
  double permanents(const std::vector<std::size_t>& a, std::vector<std::size_t> b) const {
    const std::size_t size = at_lag_[0][0].size();
    double sum = 0.0, times = 1.0;
    std::sort(b.begin(), b.end());
    // Of fields that are all the same every permutation says the same.
    const bool alike = b.front() == b.back() && std::ranges::count(a, a[0]) == std::ssize(a);
    for (std::size_t i = 2; i <= a.size(); ++i) times *= double(i);
    std::vector<std::size_t> order(b.size());
    std::iota(order.begin(), order.end(), 0);
    do {
      for (std::size_t lag = 0; lag < size; ++lag) {
        double product = 1.0;
        for (std::size_t i = 0; i < a.size(); ++i) product *= at_lag_[a[i]][b[order[i]]][lag];
        sum += product;
      }
    } while (!alike && std::next_permutation(order.begin(), order.end()));
    return alike ? times * sum : sum;
  }

 private:
  std::array<std::array<Grid<double>, 4>, 4> at_lag_;
};

}  // namespace

RidgeValues ridge_values(const Grid<float>& height, const Mask& mask, int smoothings) {
  Grid<float> map = height;
  Mask inside = mask;
  for (int pass = 0; pass < smoothings; ++pass) smooth(map, inside);
  RidgeValues values;
  for (int row = 1; row + 1 < map.rows(); ++row) {
    for (int col = 1; col + 1 < map.cols(); ++col) {
      if (!(inside(row, col) && inside(row, col - 1) && inside(row, col + 1) &&
            inside(row - 1, col) && inside(row + 1, col)))
        continue;
      const float here = map(row, col), left = map(row, col - 1), right = map(row, col + 1);
      const float above = map(row - 1, col), below = map(row + 1, col);
      values.heights.push_back(here);
      values.slopes[0].push_back(0.5f * (right - left));
      values.slopes[1].push_back(0.5f * (above - below));
      values.curvatures.push_back((left - here) + (right - here) + (above - here) + (below - here));
    }
  }
  for (auto* of : {&values.heights, &values.slopes[0], &values.slopes[1], &values.curvatures})
    standardise(*of);
  return values;
}

RidgeMoments moments_of(const RidgeValues& values) {
  const Shape height = shape_of(values.heights), curvature = shape_of(values.curvatures);
  const auto& [along_x, along_y] = values.slopes;
  double steep = 0.0;
  for (std::size_t i = 0; i < values.heights.size(); ++i)
    steep += double(values.heights[i]) * (along_x[i] * along_x[i] + along_y[i] * along_y[i]);
  steep *= 0.5 / double(std::max(values.heights.size(), std::size_t(1)));
  const double slope = 0.5 * (shape_of(along_x).kurtosis + shape_of(along_y).kurtosis);
  RidgeMoments moments;
  moments << std::asinh(height.skewness), std::asinh(steep), std::asinh(curvature.skewness),
      tail_of(height.kurtosis), tail_of(slope), tail_of(curvature.kurtosis);
  return moments;
}

int smoothings_for(const Wrinkle<>& wrinkle, double pitch) {
  constexpr double most_noise = 0.25;  // of the power of the noise functions: a fifth of the whole
  if (wrinkle.floor_mm4 == 0.0) return 0;
  int smoothings = 0;
  while (smoothings < most_smoothings) {
    const auto [wanted, noise] = curvature_power(wrinkle, pitch, smoothings);
    if (noise <= most_noise * wanted) break;
    smoothings = smoothings == 0 ? 1 : 2 * smoothings;
  }
  return smoothings;
}

RidgeScatter gaussian_scatter(const Wrinkle<>& wrinkle, const Extent& extent, double area,
                              int smoothings) {
  constexpr int most = 256;  // pixels along a side: what is alike over more adds little
  const int rows = std::min(extent.rows, most), cols = std::min(extent.cols, most);
  const auto density = spectrum_of(wrinkle);
  Amplitudes amplitudes;
  for (auto& one : amplitudes) one = Grid<std::complex<double>>(rows, cols / 2 + 1);
  for_each_index(rows, [&](int row) {
    const double y = -double(signed_frequency(row, rows)) / rows;
    for (int col = 0; col <= cols / 2; ++col) {
      const double x = double(col) / cols;
      const double power = row == 0 && col == 0 ? 0.0 : density(x / extent.pitch, y / extent.pitch);
      const auto left = responses(x, y, smoothings);
      for (std::size_t k = 0; k < 4; ++k) amplitudes[k](row, col) = std::sqrt(power) * left[k];
    }
  });
  const CrossCorrelations r(amplitudes, cols);

  // The products whose means the moments are: which fields, and with what weight.
  struct Product {
    RidgeMoment moment;
    double weight;
    std::vector<std::size_t> fields;
  };
  constexpr std::size_t h = 0, x = 1, y = 2, c = 3;
  const std::vector<Product> products{
      {height_skew, 1.0, {h, h, h}},          {high_slope, 0.5, {h, x, x}},
      {high_slope, 0.5, {h, y, y}},           {curvature_skew, 1.0, {c, c, c}},
      {height_tail, 1.0 / 3.0, {h, h, h, h}}, {slope_tail, 0.5 / 3.0, {x, x, x, x}},
      {slope_tail, 0.5 / 3.0, {y, y, y, y}},  {curvature_tail, 1.0 / 3.0, {c, c, c, c}}};
  RidgeScatter scatter = RidgeScatter::Zero();
  for (const Product& one : products) {
    for (const Product& other : products) {
      if (one.fields.size() == other.fields.size())
        scatter(one.moment, other.moment) +=
            one.weight * other.weight * r.permanents(one.fields, other.fields);
    }
  }
  return scatter * (extent.pitch * extent.pitch / area);
}

}  // namespace hada
