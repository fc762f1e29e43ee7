#include "measure/leakage.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "core/fft.h"

namespace hada {
namespace {

Grid<double> squared_modulus(const Grid<std::complex<double>>& half, int cols) {
  Grid<double> full(half.rows(), cols);
  for (int row = 0; row < full.rows(); ++row) {
    const int mirrored_row = (full.rows() - row) % full.rows();
    for (int col = 0; col < cols; ++col) {
      full(row, col) =
          std::norm(col < half.cols() ? half(row, col) : half(mirrored_row, cols - col));
    }
  }
  return full;
}

/// The circular convolution of two grids, given their transforms.
Grid<double> convolved(Grid<std::complex<double>> a, const Grid<std::complex<double>>& b,
                       int cols) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] *= b[i];
  auto product = inverse_fft(std::move(a), cols);
  for (double& value : product) value = std::max(value, 0.0);  // rounding may undercut 0
  return product;
}

}  // namespace

Leakage leakage(const Spectrum& spectrum, double reach) {
  const Grid<double>& taper = spectrum.taper;
  double sum_w2 = 0.0;
  for (const double weight : taper) sum_w2 += weight * weight;
  const double unit_sum = 1.0 / (sum_w2 * double(taper.size()));  // Parseval

  Grid<double> near = squared_modulus(fft(taper), taper.cols());
  Grid<double> far = near;
  double far_share = 0.0;
  for (int row = 0; row < near.rows(); ++row) {
    for (int col = 0; col < near.cols(); ++col) {
      const double steps =
          std::hypot(signed_frequency(row, near.rows()), signed_frequency(col, near.cols()));
      near(row, col) *= steps <= reach ? unit_sum : 0.0;
      far(row, col) *= steps <= reach ? 0.0 : unit_sum;
      far_share += far(row, col);
    }
  }
  const auto power = fft(spectrum.power);
  return {convolved(fft(near), power, taper.cols()), convolved(fft(far), power, taper.cols()),
          far_share};
}

}  // namespace hada
