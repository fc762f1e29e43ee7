#include "measure/cepstrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

// Of the highest power, what is left of a wave that is not there.
constexpr double faintest = 1e-12;
constexpr double emptied_steps = 2.5;  // of frequency around 0, by any levelling

Grid<double> cepstrum(const Spectrum& spectrum,
                      const std::function<double(double, double)>& expected) {
  const Extent& extent = spectrum.extent;
  const double least = faintest * *std::max_element(spectrum.power.begin(), spectrum.power.end());
  Grid<std::complex<double>> logarithms(extent.rows, extent.cols / 2 + 1);
  for_each_index(logarithms.rows(), [&](int row) {
    for (int col = 0; col < logarithms.cols(); ++col) {
      if (std::hypot(signed_frequency(row, extent.rows), col) <= emptied_steps) continue;
      const double power = std::max(spectrum.power(row, col), least);
      const double model = std::max(expected(spectrum.fx(col), spectrum.fy(row)), least);
      logarithms(row, col) = std::log(power / model);
    }
  });
  return inverse_fft(std::move(logarithms), extent.cols);
}

/// Where the parabola through three neighbours has its vertex, from the middle one, the highest.
double vertex(double before, double middle, double after) {
  const double bend = 2.0 * middle - before - after;
  return bend > 0.0 ? 0.5 * (after - before) / bend : 0.0;
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
      std::min(int(longest / extent.pitch) + 1, std::min(extent.rows, extent.cols) / 2 - 1);
  std::vector<Peak> peaks;
  for (int i = 0; i <= reach; ++i) {  // downwards: -p is in the other half
    for (int j = i == 0 ? 1 : -reach; j <= reach; ++j) {
      if (!is_peak(i, j)) continue;
      const Eigen::Vector2d pixels(j + vertex(at(i, j - 1), at(i, j), at(i, j + 1)),
                                   -i - vertex(at(i - 1, j), at(i, j), at(i + 1, j)));
      const Eigen::Vector2d distance = extent.pitch * pixels;
      if (distance.norm() < shortest || distance.norm() > longest) continue;
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
