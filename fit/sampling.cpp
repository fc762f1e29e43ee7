#include "fit/sampling.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "core/fft.h"
#include "core/parallel.h"
#include "fit/whittle.h"

namespace hada {

Grid<double> taper_overlap(const Grid<double>& taper) {
  Grid<double> padded(2 * taper.rows(), 2 * taper.cols());
  double sum_w2 = 0.0;
  for (int row = 0; row < taper.rows(); ++row) {
    for (int col = 0; col < taper.cols(); ++col) {
      padded(row, col) = taper(row, col);
      sum_w2 += taper(row, col) * taper(row, col);
    }
  }
  auto transformed = fft(padded);
  for (auto& value : transformed) value = std::norm(value) / sum_w2;
  return inverse_fft(std::move(transformed), padded.cols());
}

Grid<double> expected_power(const Wrinkle<>& wrinkle, const Grid<double>& overlap,
                            const Extent& extent) {
  std::vector<GaussianCovariance<>> covariances;
  std::vector<RepeatedCovariance<>> repeated;
  std::vector<WovenCovariance<>> woven;
  for (const auto& component : wrinkle.components) covariances.push_back(autocovariance(component));
  for (const auto& noise : wrinkle.repeated) repeated.push_back(autocovariance(noise));
  for (const auto& noise : wrinkle.woven) woven.push_back(autocovariance(noise));

  // Lags that differ by the size of the map are one to its ordinates.
  Grid<double> folded(extent.rows, extent.cols);
  for_each_index(extent.rows, [&](int row) {
    for (const int lag_row : {row, row + extent.rows}) {
      const double dy = -signed_frequency(lag_row, overlap.rows()) * extent.pitch;
      for (int col = 0; col < overlap.cols(); ++col) {
        const double dx = signed_frequency(col, overlap.cols()) * extent.pitch;
        double sum = 0.0;
        for (const auto& covariance : covariances) sum += value_at(covariance, dx, dy);
        for (const auto& covariance : repeated) sum += value_at(covariance, dx, dy);
        for (const auto& covariance : woven) sum += value_at(covariance, dx, dy);
        folded(row, col % extent.cols) += sum * overlap(lag_row, col);
      }
    }
  });
  const auto half = fft(folded);
  Grid<double> power(extent.rows, half.cols());
  for (std::size_t i = 0; i < power.size(); ++i)
    power[i] = half[i].real() * extent.pitch * extent.pitch + wrinkle.floor_mm4;
  return power;
}

std::vector<Cell> corrected(std::vector<Cell> cells, const Wrinkle<>& wrinkle,
                            const Grid<double>& overlap, const Extent& extent) {
  const auto expected = expected_power(wrinkle, overlap, extent);
  for (Cell& cell : cells) {
    cell.correction = 1.0;
    if (cell.count == 1) cell.leakage = 0.0;  // the correction brings it
  }
  const auto model = densities(wrinkle, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Cell& cell = cells[i];
    double sum = 0.0;
    for (const int ordinate : cell.ordinates) sum += expected[std::size_t(ordinate)];
    const double sent = model[i] - cell.leakage - cell.noise;
    // What sends nothing of its own receives from elsewhere alone: no factor can say so.
    cell.correction = sent > 0.0 ? std::max(sum / cell.count - cell.leakage, 0.0) / sent : 0.0;
  }
  return cells;
}

std::vector<Cell> trusted(const std::vector<Cell>& cells, const Wrinkle<>& wrinkle,
                          const Extent& extent, const TrustOptions& options) {
  const double pitch = extent.pitch;
  std::vector<Cell> kept;
  const auto model = densities(wrinkle, cells);
  const double faintest = options.faintest * *std::max_element(model.begin(), model.end());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const double image_fx = cell.fx - std::copysign(1.0 / pitch, cell.fx);
    const double image_fy = cell.fy - std::copysign(1.0 / pitch, cell.fy);
    double aliased = 0.0;
    const auto add = [&](const auto& noise) {
      // Two amplitudes a and b in step add 2 a b to their power a^2 + b^2.
      const double itself = psd(noise, cell.fx, cell.fy);
      aliased += 2.0 * std::sqrt(itself * psd(noise, image_fx, cell.fy));
      aliased += 2.0 * std::sqrt(itself * psd(noise, cell.fx, image_fy));
    };
    for_each_noise(wrinkle, add);
    const double steps = std::hypot(cell.fx * extent.width(), cell.fy * extent.height());
    const double most = steps < options.slow ? options.most_correction : options.most_gained;
    if (model[i] > faintest && cell.correction < most && cell.correction * most > 1.0 &&
        aliased <= options.most_aliased * model[i] &&
        cell.leakage <= options.most_leakage * model[i])
      kept.push_back(cell);
  }
  return kept;
}

}  // namespace hada
