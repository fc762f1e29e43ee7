#include "fit/grain_rotation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;
constexpr int most_moves = 8;  // of an angle by one step

double at(const std::vector<double>& covariance, double places) {
  const double place = std::abs(places) * covariance_steps;
  const auto k = std::size_t(place);
  if (k + 1 >= covariance.size()) return 0.0;
  const double part = place - double(k);
  return (1.0 - part) * covariance[k] + part * covariance[k + 1];
}

/// What is expected of half of the periodogram of turned grain of variance 1.
Grid<std::complex<double>> turned_density(const GrainModel& model, const GrainSpectrum& spectrum,
                                          double angle_rad) {
  const int rows = spectrum.y.length, cols = spectrum.x.length;
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const int places = int(std::hypot(rows, cols) / std::min(model.scale_x, model.scale_y)) + 2;
  const auto along = grain_covariance(model, 'C', places);
  const auto down = grain_covariance(model, 'R', places);
  // Lags from 1 - length to length - 1 fold onto one period: the periodogram has no others.
  Grid<double> folded(rows, cols);
  const auto seen = [&](int lag_down, int lag) {
    const double x = lag, y = -lag_down;  // rows count downwards
    return at(along, (c * x + s * y) / model.scale_x) * at(down, (c * y - s * x) / model.scale_y) *
           spectrum.x.overlap[std::size_t(std::abs(lag))] *
           spectrum.y.overlap[std::size_t(std::abs(lag_down))];
  };
  for_each_index(rows, [&](int row) {
    for (int col = 0; col < cols; ++col) {
      double sum = seen(row, col);
      if (col > 0) sum += seen(row, col - cols);
      if (row > 0) sum += seen(row - rows, col);
      if (row > 0 && col > 0) sum += seen(row - rows, col - cols);
      folded(row, col) = sum;
    }
  });
  return fft(folded);
}

}  // namespace

GrainRotation::GrainRotation(const Grid<float>& scores) : spectrum_(grain_spectrum(scores)) {
  const auto transform = tapered_transform(scores, GrainSpectrumOptions{}.taper);
  independence_ = transform.independence;
  power_ = Grid<double>(transform.half.rows(), transform.half.cols());
  for (std::size_t k = 0; k < power_.size(); ++k) power_[k] = std::norm(transform.half[k]);
}

double GrainRotation::log_likelihood(const GrainModel& model, const GrainNuisance& nuisance,
                                     double angle_rad) const {
  // The cells of the model may be those of another spectrum, of the picture turned back.
  GrainModel still = model;
  still.along.assign(std::size_t(spectrum_.x.cells()), 0.0);
  still.down.assign(std::size_t(spectrum_.y.cells()), 0.0);
  std::vector<double> noise;  // white noise and the error of quantising
  expected_cells(still, nuisance, spectrum_, noise);
  const auto density = turned_density(model, spectrum_, angle_rad);
  const auto x_cell = cell_of_frequency(spectrum_.x), y_cell = cell_of_frequency(spectrum_.y);
  const int rows = power_.rows(), cols = spectrum_.x.length;
  const double blur = -4.0 * pi * pi * nuisance.blur_px * nuisance.blur_px;
  std::vector<double> blur_x;
  for (int col = 0; col < power_.cols(); ++col)
    blur_x.push_back(std::exp(blur * col * col / (double(cols) * cols)));
  std::vector<double> sums(std::size_t(rows), 0.0);
  for_each_index(rows, [&](int row) {
    const int i = std::abs(signed_frequency(row, rows));
    const double grain = nuisance.variance * std::exp(blur * double(i) * i / (double(rows) * rows));
    const double* still_row =
        &noise[std::size_t(y_cell[std::size_t(i)]) * std::size_t(spectrum_.x.cells())];
    double sum = 0.0;
    for (int col = 0; col < power_.cols(); ++col) {
      const double weight = ordinate_weight(row, col, rows, cols);
      if (weight == 0.0) continue;
      const double expected =
          grain * blur_x[std::size_t(col)] * std::max(density(row, col).real(), 0.0) +
          still_row[x_cell[std::size_t(col)]];
      sum -= weight * (std::log(expected) + power_(row, col) / expected);
    }
    sums[std::size_t(row)] = sum;
  });
  double sum = 0.0;
  for (const double row : sums) sum += row;
  return independence_ * sum;
}

GrainAngle likeliest_angle(const GrainRotation& rotation, const SequenceCandidate& grain,
                           double start_rad) {
  const auto likelihood = [&](double angle) {
    return rotation.log_likelihood(grain.model, grain.fit.nuisance, angle);
  };
  double angle = start_rad, best = likelihood(angle), sigma = 0.0;
  for (const double step : {1.0 * degree, 0.3 * degree, 0.1 * degree, 0.03 * degree}) {
    for (int moves = 0; moves < most_moves; ++moves) {
      const double before = likelihood(angle - step), after = likelihood(angle + step);
      if (before > best || after > best) {
        angle += after > before ? step : -step;
        best = std::max(before, after);
        continue;
      }
      const double bend = 2.0 * best - before - after;
      if (!(bend > 0.0)) break;
      // Between neighbouring ordinates the likelihood is rough: the widest top tells.
      sigma = std::max(sigma, step / std::sqrt(bend));
      const double top = angle + 0.5 * step * (after - before) / bend;
      const double height = likelihood(top);
      if (height > best) {
        best = height;
        angle = top;
      }
      break;
    }
    if (step < sigma) break;  // no finer than it is known
  }
  return {angle, sigma > 0.0 ? sigma : degree, best - likelihood(0.0)};
}

}  // namespace hada
