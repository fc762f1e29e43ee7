#include "fit/grain_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int left_out = 2;  // frequencies around 0 that the mean has emptied

std::vector<double> tukey(int length, double share) {
  std::vector<double> taper(static_cast<std::size_t>(length), 1.0);
  const double edge = 0.5 * share * length;
  for (int k = 0; k < length; ++k) {
    const double from_end = std::min(k + 0.5, length - k - 0.5);
    if (from_end < edge)
      taper[std::size_t(k)] = 0.5 - 0.5 * std::cos(std::numbers::pi * from_end / edge);
  }
  return taper;
}

double sum_of_powers(const std::vector<double>& values, int power) {
  double sum = 0.0;
  for (const double v : values) sum += std::pow(v, power);
  return sum;
}

std::vector<double> overlap_of(const std::vector<double>& taper) {
  // The autocorrelation by way of the transform of the padded taper.
  const int n = 2 * int(taper.size());
  Grid<double> padded(1, n);
  std::copy(taper.begin(), taper.end(), padded.begin());
  auto half = fft(padded);
  for (auto& value : half) value = std::norm(value);
  const auto lags = inverse_fft(std::move(half), n);
  std::vector<double> overlap(taper.size());
  for (std::size_t k = 0; k < overlap.size(); ++k) overlap[k] = lags[k] / lags[0];
  return overlap;
}

GrainAxis axis_of(int length, const std::vector<double>& taper,
                  const GrainSpectrumOptions& options) {
  GrainAxis axis{length, {}, overlap_of(taper)};
  const int end = length / 2 + 1;
  for (int k = 0; k < end;) {
    axis.edges.push_back(k);
    k += k < options.single ? 1 : std::max(1, int(options.growth * k));
  }
  axis.edges.push_back(end);
  return axis;
}

}  // namespace

std::vector<int> cell_of_frequency(const GrainAxis& axis) {
  std::vector<int> cell;
  for (int c = 0; c < axis.cells(); ++c) {
    cell.resize(std::size_t(axis.edges[std::size_t(c + 1)]), c);
  }
  return cell;
}

TaperedTransform tapered_transform(const Grid<float>& scores, double taper) {
  const int rows = scores.rows(), cols = scores.cols();
  const auto along = tukey(cols, taper), down = tukey(rows, taper);
  const double energy = sum_of_powers(along, 2) * sum_of_powers(down, 2);
  const double unit = 1.0 / std::sqrt(energy);
  Grid<double> tapered(rows, cols);
  for_each_index(rows, [&](int row) {
    for (int col = 0; col < cols; ++col)
      tapered(row, col) =
          unit * scores(row, col) * along[std::size_t(col)] * down[std::size_t(row)];
  });
  return {fft(tapered), energy * energy / (sum_of_powers(along, 4) * sum_of_powers(down, 4)) /
                            (double(rows) * cols)};
}

double ordinate_weight(int row, int col, int rows, int cols) {
  if (std::abs(signed_frequency(row, rows)) < left_out && col < left_out) return 0.0;
  return col == 0 || 2 * col == cols ? 0.5 : 1.0;
}

GrainSpectrum grain_spectrum(const Grid<float>& scores, const GrainSpectrumOptions& options) {
  const int rows = scores.rows(), cols = scores.cols();
  GrainSpectrum spectrum;
  spectrum.x = axis_of(cols, tukey(cols, options.taper), options);
  spectrum.y = axis_of(rows, tukey(rows, options.taper), options);
  const auto [half, independence] = tapered_transform(scores, options.taper);
  const auto x_cell = cell_of_frequency(spectrum.x), y_cell = cell_of_frequency(spectrum.y);
  spectrum.power = Grid<double>(spectrum.y.cells(), spectrum.x.cells());
  spectrum.count = Grid<double>(spectrum.y.cells(), spectrum.x.cells());
  for (int row = 0; row < rows; ++row) {
    const int r = y_cell[std::size_t(std::abs(signed_frequency(row, rows)))];
    for (int col = 0; col < half.cols(); ++col) {
      const double weight = ordinate_weight(row, col, rows, cols);
      const int c = x_cell[std::size_t(col)];
      spectrum.power(r, c) += weight * std::norm(half(row, col));
      spectrum.count(r, c) += weight;
    }
  }
  for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
    if (spectrum.count[k] == 0.0) continue;
    spectrum.power[k] /= spectrum.count[k];
    spectrum.count[k] *= independence;
  }
  return spectrum;
}

std::vector<double> seen_through(const GrainAxis& axis, const std::vector<double>& density) {
  const int n = int(density.size()), length = axis.length;
  // Autocovariance, narrowed by the taper, and back; both are even, so that cosines are all.
  Grid<double> line(1, n);
  std::copy(density.begin(), density.end(), line.begin());
  const auto covariance = fft(line);  // n times the autocovariance, real
  Grid<double> lags(1, 2 * length);
  for (int lag = 0; lag < length; ++lag) {
    const double value =
        covariance(0, std::min(lag, n - lag)).real() / n * axis.overlap[std::size_t(lag)];
    lags(0, lag) = value;
    if (lag > 0) lags(0, 2 * length - lag) = value;
  }
  const auto power = fft(lags);
  std::vector<double> seen(std::size_t(length / 2 + 1));
  for (std::size_t k = 0; k < seen.size(); ++k) seen[k] = std::max(power[2 * k].real(), 1e-300);
  return seen;
}

std::vector<double> cell_means(const GrainAxis& axis, const std::vector<double>& at) {
  std::vector<double> means;
  for (int c = 0; c < axis.cells(); ++c) {
    double sum = 0.0, count = 0.0;
    for (int k = axis.edges[std::size_t(c)]; k < axis.edges[std::size_t(c + 1)]; ++k) {
      const double ordinates = k == 0 || 2 * k == axis.length ? 0.5 : 1.0;
      sum += ordinates * at[std::size_t(k)];
      count += ordinates;
    }
    means.push_back(sum / count);
  }
  return means;
}

}  // namespace hada
