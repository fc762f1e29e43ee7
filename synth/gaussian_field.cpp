#include "synth/gaussian_field.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"
#include "synth/white_noise.h"

namespace hada {
namespace {

// Below this share of the largest density a frequency is lost in the rounding of float heights.
constexpr double negligible = 1e-18;

/// Complex numbers with mean 0 and mean square modulus 1, Gaussian, one for each frequency (i, j);
/// that of (-i, -j) is the conjugate of that of (i, j), so that the field is real.
class Coefficients {
 public:
  Coefficients(Seed seed, int i) : row_(mixed(seed, i)), mirrored_(mixed(seed, -i)), i_(i) {}

  std::complex<float> at(int j) const {
    if (j == 0 && i_ < 0) return std::conj(drawn(mixed(mirrored_, 0)));
    return drawn(mixed(row_, j));
  }

 private:
  static std::complex<float> drawn(std::uint64_t key) {
    constexpr double half = 1.0 / std::numbers::sqrt2;
    return {float(half * normal_of(key)), float(half * normal_of(mixed(key, 1)))};
  }

  std::uint64_t row_, mirrored_;
  int i_;
};

/// Half a sample further on, for every frequency of a line of `n` samples: pixels are sampled at
/// their centres, but the field is anchored to the border of the grid, which no pitch moves.
std::vector<std::complex<float>> half_sample_turns(int count, int n) {
  std::vector<std::complex<float>> turns;
  for (int k = 0; k < count; ++k) {
    const double turn = std::numbers::pi * signed_frequency(k, n) / n;
    turns.emplace_back(float(std::cos(turn)), float(std::sin(turn)));
  }
  return turns;
}

bool is_nyquist(int k, int n) {
  return 2 * k == n;
}

// The density as real parts, where the coefficients will stand: a map of its own would cost the
// time in which fresh memory is had.
Grid<std::complex<float>> sample(const PsdOfRow& psd, const Extent& extent) {
  Grid<std::complex<float>> density(extent.rows, extent.cols / 2 + 1);
  std::vector<double> fx;
  for (int col = 0; col < density.cols(); ++col) fx.push_back(col / extent.width());
  for_each_index(extent.rows, [&](int row) {
    if (is_nyquist(row, extent.rows)) return;
    const double fy = -signed_frequency(row, extent.rows) / extent.height();  // rows run downward
    std::vector<float> line(fx.size());
    psd(fx, fy, line.data());
    if (is_nyquist(density.cols() - 1, extent.cols)) line.back() = 0.0f;
    if (row == 0) line.front() = 0.0f;
    std::copy(line.begin(), line.end(), density.row(row).begin());
  });
  return density;
}

float largest_real(const Grid<std::complex<float>>& grid) {
  float largest = 0.0f;
  for (const auto& value : grid) largest = std::max(largest, value.real());
  return largest;
}

// a b, without the care for infinities that operator* takes.
std::complex<float> product(const std::complex<float>& a, const std::complex<float>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

Grid<float> gaussian_field_by_rows(const PsdOfRow& psd, const Extent& extent, Seed seed) {
  Grid<std::complex<float>> half = sample(psd, extent);
  if (half.empty()) return {};
  const double least = negligible * largest_real(half);
  const double area = extent.width() * extent.height();
  const auto size = double(extent.rows) * extent.cols;  // inverse_fft divides by it
  const auto row_turns = half_sample_turns(extent.rows, extent.rows);
  const auto col_turns = half_sample_turns(half.cols(), extent.cols);

  for_each_index(half.rows(), [&](int row) {
    const Coefficients coefficients(seed, signed_frequency(row, extent.rows));
    for (int col = 0; col < half.cols(); ++col) {
      std::complex<float>& value = half(row, col);
      const float density = std::exchange(value, {}).real();
      if (density <= least) continue;
      const float amplitude = float(size * std::sqrt(density / area));
      value = amplitude * product(coefficients.at(col), product(row_turns[std::size_t(row)],
                                                                col_turns[std::size_t(col)]));
    }
  });
  return inverse_fft(std::move(half), extent.cols);
}

}  // namespace hada
