#include "measure/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

#include "core/error.h"
#include "core/fft.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr int spanning_peaks = 14;       // strong ones, of which pairs are tried
constexpr double reach_bins = 0.75;      // a peak this far off is not on a lattice
constexpr double nearly_as_much = 0.08;  // less explained is the price of a coarser lattice

int wrapped_index(int k, int n) {
  return ((k % n) + n) % n;
}

/// The offset of a parabola's vertex from the middle of three samples, -1/2 to 1/2.
double vertex_of(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

bool is_local_maximum(const Grid<double>& power, int row, int col) {
  const double value = power(row, col);
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      const double other =
          power(wrapped_index(row + dr, power.rows()), wrapped_index(col + dc, power.cols()));
      if (other > value || (other == value && (dr < 0 || (dr == 0 && dc < 0)))) return false;
    }
  }
  return value > 0.0;
}

/// The median power in the square of 15 x 15 bins around (row, col).
double surroundings(const Grid<double>& power, int row, int col) {
  constexpr int reach = 7;
  std::vector<double> around;
  for (int dr = -reach; dr <= reach; ++dr) {
    for (int dc = -reach; dc <= reach; ++dc) {
      around.push_back(
          power(wrapped_index(row + dr, power.rows()), wrapped_index(col + dc, power.cols())));
    }
  }
  return std::max(quantile(around, 0.5), std::numeric_limits<double>::min());
}

/// A basis made as short as can be (Lagrange and Gauss), turned into the upper half plane.
std::array<Eigen::Vector2d, 2> reduced(Eigen::Vector2d a, Eigen::Vector2d b) {
  for (;;) {
    if (a.squaredNorm() > b.squaredNorm()) std::swap(a, b);
    const double share = a.dot(b) / a.squaredNorm();
    constexpr double half =
        0.5 + 1e-9;  // at one half there are two shortest, and no end between them
    if (!(std::abs(share) > half)) break;
    b -= std::round(share) * a;
  }
  for (Eigen::Vector2d* v : {&a, &b}) {
    if (v->y() < 0.0 || (v->y() == 0.0 && v->x() < 0.0)) *v = -*v;
  }
  return {a, b};
}

Eigen::Matrix2d columns(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Eigen::Matrix2d basis;
  basis << a, b;
  return basis;
}

/// Which peaks lie on the lattice of `basis`, as how much of the amplitude, less what chance gives.
struct Match {
  double explained = 0.0;
  int count = 0;
};

Match match(const std::vector<SpectralPeak>& peaks, const Eigen::Matrix2d& basis,
            const Eigen::Vector2d& resolution) {
  const Eigen::Matrix2d inverse = basis.inverse();
  double all = 0.0, on_it = 0.0;
  Match found;
  for (const auto& peak : peaks) {
    const double amplitude = std::sqrt(peak.power);
    const Eigen::Vector2d whole = (inverse * peak.frequency).array().round();
    const Eigen::Vector2d off = (basis * whole - peak.frequency).cwiseQuotient(resolution);
    // The basis is itself off by part of a bin, and n times that n cells away.
    const double reach = reach_bins * (1.0 + 0.1 * (whole.cwiseAbs().maxCoeff() - 1.0));
    all += amplitude;
    if (off.norm() > reach || whole.isZero()) continue;
    on_it += amplitude;
    ++found.count;
  }
  const double cell_bins = std::abs(basis.determinant()) / resolution.prod();
  const double chance = std::min(0.9, std::numbers::pi * reach_bins * reach_bins / cell_bins);
  found.explained = (on_it / all - chance) / (1.0 - chance);
  return found;
}

/// The basis that agrees best with the peaks on it, in the sense of amplitudes.
Eigen::Matrix2d refined(const std::vector<SpectralPeak>& peaks, const Eigen::Matrix2d& basis,
                        const Eigen::Vector2d& resolution) {
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero(), products = Eigen::Matrix2d::Zero();
  const Eigen::Matrix2d inverse = basis.inverse();
  for (const auto& peak : peaks) {
    const Eigen::Vector2d whole = (inverse * peak.frequency).array().round();
    const Eigen::Vector2d off = (basis * whole - peak.frequency).cwiseQuotient(resolution);
    if (off.norm() > 2.0 * reach_bins) continue;
    const double weight = std::sqrt(peak.power);
    moments += weight * whole * whole.transpose();
    products += weight * peak.frequency * whole.transpose();
  }
  return moments.determinant() > 0.0 ? Eigen::Matrix2d(products * moments.inverse()) : basis;
}

std::vector<Eigen::Matrix2d> candidates(const std::vector<SpectralPeak>& peaks,
                                        const Eigen::Vector2d& resolution) {
  constexpr double fewest_bins = 9.0;  // of a cell: finer lattices explain everything
  std::vector<Eigen::Matrix2d> all;
  const std::size_t count = std::min<std::size_t>(peaks.size(), spanning_peaks);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (const auto& [p, q] : {std::pair{1, 1}, {2, 1}, {1, 2}, {2, 2}, {3, 1}, {1, 3}}) {
        const auto [a, b] = reduced(peaks[i].frequency / p, peaks[j].frequency / q);
        const Eigen::Matrix2d basis = columns(a, b);
        const double cell_bins = std::abs(basis.determinant()) / resolution.prod();
        if (cell_bins < fewest_bins || a.cwiseQuotient(resolution).norm() < 2.0) continue;
        all.push_back(basis);
      }
    }
  }
  return all;
}

}  // namespace

std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, const PeakOptions& options) {
  const Grid<double>& power = spectrum.power;
  const auto at = [&](int row, int col) {
    return std::log(
        std::max(power(wrapped_index(row, power.rows()), wrapped_index(col, power.cols())),
                 std::numeric_limits<double>::min()));
  };
  std::vector<SpectralPeak> peaks;
  for (int row = 0; row < power.rows(); ++row) {
    for (int col = 0; col <= power.cols() / 2; ++col) {
      const int i = signed_frequency(row, power.rows());
      // Near zero lie the uneven light and the lobe of the mean.
      if ((std::abs(i) <= 2 && col <= 2) || (col == 0 && i > 0)) continue;
      if (!is_local_maximum(power, row, col)) continue;
      const double df_x = vertex_of(at(row, col - 1), at(row, col), at(row, col + 1));
      const double df_y = vertex_of(at(row - 1, col), at(row, col), at(row + 1, col));
      Eigen::Vector2d frequency(spectrum.fx(col) + df_x / spectrum.extent.width(),
                                spectrum.fy(row) - df_y / spectrum.extent.height());
      if (frequency.y() < 0.0) frequency = -frequency;
      peaks.push_back({frequency, power(row, col), 0.0});
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const auto& a, const auto& b) { return a.power > b.power; });
  std::vector<SpectralPeak> kept;
  for (SpectralPeak& peak : peaks) {
    if (int(kept.size()) == options.most) break;
    if (!kept.empty() && peak.power < options.least_share * kept.front().power) break;
    const int col = int(std::lround(peak.frequency.x() * spectrum.extent.width()));
    const int row = int(std::lround(-peak.frequency.y() * spectrum.extent.height()));
    peak.prominence = peak.power / surroundings(power, row, col);
    if (peak.prominence >= options.least_prominence) kept.push_back(peak);
  }
  return kept;
}

Lattice lattice_of(const std::vector<SpectralPeak>& peaks, const Eigen::Vector2d& resolution) {
  const auto bases = candidates(peaks, resolution);
  std::vector<Match> matches;
  double best = 0.0;
  for (const auto& basis : bases) {
    matches.push_back(match(peaks, basis, resolution));
    best = std::max(best, matches.back().explained);
  }
  int chosen = -1;
  double largest = 0.0;
  for (std::size_t k = 0; k < bases.size(); ++k) {
    if (matches[k].explained < best - nearly_as_much) continue;
    // Of lattices as coarse as each other, to a per cent, the one that explains more.
    const double cell = std::abs(bases[k].determinant());
    const bool coarser = cell > 1.01 * largest;
    const bool better = cell > 0.99 * largest && chosen >= 0 &&
                        matches[k].explained > matches[std::size_t(chosen)].explained;
    if (!coarser && !better) continue;
    chosen = int(k);
    largest = cell;
  }
  if (chosen < 0) {
    throw Error(
        "lattice: the map has no two peaks that span a lattice; give a picture that shows at least "
        "three periods each way, sharply");
  }
  Eigen::Matrix2d basis = bases[std::size_t(chosen)];
  constexpr int rounds = 3;
  for (int k = 0; k < rounds; ++k) basis = refined(peaks, basis, resolution);
  const auto [first, second] = reduced(basis.col(0), basis.col(1));
  const Match found = match(peaks, columns(first, second), resolution);
  return {first, second, found.explained, found.count};
}

}  // namespace hada
