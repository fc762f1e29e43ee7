#include "measure/cepstrum.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double faintest =
    1e-12;  // of the highest power, what is left of a wave that is not there

Grid<double> cepstrum(const Spectrum& spectrum,
                      const std::function<double(double, double)>& expected) {
  const Extent& extent = spectrum.extent;
  const double least = faintest * *std::max_element(spectrum.power.begin(), spectrum.power.end());
  Grid<std::complex<double>> logarithms(extent.rows, extent.cols / 2 + 1);
  for_each_index(logarithms.rows(), [&](int row) {
    for (int col = 0; col < logarithms.cols(); ++col) {
      if (row == 0 && col == 0) continue;  // levelling emptied it
      const double power = std::max(spectrum.power(row, col), least);
      const double model = std::max(expected(spectrum.fx(col), spectrum.fy(row)), least);
      logarithms(row, col) = std::log(power / model);
    }
  });
  return inverse_fft(logarithms, extent.cols);
}

}  // namespace

std::vector<Eigen::Vector2d> repetitions(
    const Spectrum& spectrum, const std::function<double(double fx, double fy)>& expected,
    double shortest, double longest, int most) {
  struct Peak {
    Eigen::Vector2d distance;
    double height;
  };
  const Extent& extent = spectrum.extent;
  const Grid<double> map = cepstrum(spectrum, expected);
  const auto at = [&](int i, int j) {
    return map((i + extent.rows) % extent.rows, (j + extent.cols) % extent.cols);
  };
  const auto is_peak = [&](int i, int j) {
    for (int di = -1; di <= 1; ++di) {
      for (int dj = -1; dj <= 1; ++dj)
        if (at(i + di, j + dj) > at(i, j)) return false;
    }
    return true;
  };
  const int reach =
      std::min(int(longest / extent.pitch), std::min(extent.rows, extent.cols) / 2 - 1);
  std::vector<Peak> peaks;
  for (int i = 0; i <= reach; ++i) {  // downwards: -p is in the other half
    for (int j = i == 0 ? 1 : -reach; j <= reach; ++j) {
      const Eigen::Vector2d distance(j * extent.pitch, -i * extent.pitch);
      if (distance.norm() < shortest || distance.norm() > longest || !is_peak(i, j)) continue;
      peaks.push_back({distance, at(i, j)});
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.height > b.height; });
  std::vector<Eigen::Vector2d> distances;
  for (std::size_t k = 0; k < peaks.size() && int(k) < most; ++k)
    distances.push_back(peaks[k].distance);
  return distances;
}

}  // namespace hada
