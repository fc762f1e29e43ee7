#include "synth/gaussian_field.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

// Below this share of the largest density a frequency is lost in the rounding of float heights.
constexpr double negligible = 1e-18;

/// A complex number with mean 0 and mean square modulus 1, Gaussian; that of (-i, -j) is its
/// conjugate, so that the field is real.
std::complex<double> coefficient(Seed seed, int i, int j) {
  if (j < 0 || (j == 0 && i < 0)) return std::conj(coefficient(seed, -i, -j));
  const double radius = std::sqrt(-std::log(uniform(seed, i, j, 0)));
  return std::polar(radius, 2.0 * std::numbers::pi * uniform(seed, i, j, 1));
}

/// Half a sample further on, for every frequency of a line of `n` samples: pixels are sampled at
/// their centres, but the field is anchored to the border of the grid, which no pitch moves.
std::vector<std::complex<double>> half_sample_turns(int count, int n) {
  std::vector<std::complex<double>> turns;
  for (int k = 0; k < count; ++k)
    turns.push_back(std::polar(1.0, std::numbers::pi * signed_frequency(k, n) / n));
  return turns;
}

bool is_nyquist(int k, int n) {
  return 2 * k == n;
}

Grid<double> sample(const std::function<double(double, double)>& psd, const Extent& extent) {
  Grid<double> density(extent.rows, extent.cols / 2 + 1);
  for_each_index(extent.rows, [&](int row) {
    if (is_nyquist(row, extent.rows)) return;
    const double fy = -signed_frequency(row, extent.rows) / extent.height();  // rows run downward
    for (int col = 0; col < density.cols(); ++col) {
      if (is_nyquist(col, extent.cols) || (row == 0 && col == 0)) continue;
      density(row, col) = psd(col / extent.width(), fy);
    }
  });
  return density;
}

}  // namespace

Grid<float> gaussian_field(const std::function<double(double fx, double fy)>& psd,
                           const Extent& extent, Seed seed) {
  const Grid<double> density = sample(psd, extent);
  if (density.empty()) return {};
  const double least = negligible * *std::max_element(density.begin(), density.end());
  const double area = extent.width() * extent.height();
  const auto size = double(extent.rows) * extent.cols;  // inverse_fft divides by it
  const auto row_turns = half_sample_turns(extent.rows, extent.rows);
  const auto col_turns = half_sample_turns(density.cols(), extent.cols);

  Grid<std::complex<float>> half(density.rows(), density.cols());
  for_each_index(density.rows(), [&](int row) {
    const int i = signed_frequency(row, extent.rows);
    for (int col = 0; col < density.cols(); ++col) {
      if (density(row, col) <= least) continue;
      const double amplitude = size * std::sqrt(density(row, col) / area);
      half(row, col) =
          std::complex<float>(amplitude * coefficient(seed, i, col) * row_turns[std::size_t(row)] *
                              col_turns[std::size_t(col)]);
    }
  });
  return inverse_fft(half, extent.cols);
}

}  // namespace hada
