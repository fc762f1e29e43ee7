#include "fit/ring_lines.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/grid.h"
#include "core/parallel.h"

namespace hada {
namespace {

/// Where, between two neighbours of a lattice, a ring ends; and which way the lattice ran.
struct Crossing {
  std::size_t ring;
  bool along_row;
  double row, col;  // px
};

void add_crossings(std::vector<Crossing>& found, const std::vector<double>& radii, double here,
                   double there, bool along_row, double row, double col, double step_px) {
  const double low = std::min(here, there), high = std::max(here, there);
  const auto first = std::upper_bound(radii.begin(), radii.end(), low);
  const auto last = std::upper_bound(radii.begin(), radii.end(), high);
  for (auto radius = first; radius < last; ++radius) {
    const double share = (*radius - here) / (there - here) * step_px;
    found.push_back({std::size_t(radius - radii.begin()), along_row, row + (along_row ? 0 : share),
                     col + (along_row ? share : 0)});
  }
}

std::vector<Crossing> crossings(const GrowthSolid& solid, const Cut& cut, const Extent& extent,
                                int step_px) {
  const int rows = (extent.rows - 1) / step_px + 1, cols = (extent.cols - 1) / step_px + 1;
  Grid<double> rho(rows, cols, 0.0);
  for_each_index(rows, [&](int i) {
    for (int j = 0; j < cols; ++j) {
      const Eigen::Vector2d place = extent.place(i * step_px, j * step_px);
      rho(i, j) = local_of(solid, cut.at(place.x(), place.y()), false).rho;
    }
  });
  std::vector<double> radii = solid.radii;
  std::vector<Crossing> found;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) {
      const double across = j + 1 < cols ? rho(i, j + 1) - rho(i, j) : 0.0;
      const double down = i + 1 < rows ? rho(i + 1, j) - rho(i, j) : 0.0;
      const bool along_row = std::abs(across) >= std::abs(down);
      if (along_row && j + 1 < cols)
        add_crossings(found, radii, rho(i, j), rho(i, j + 1), true, i * step_px, j * step_px,
                      step_px);
      if (!along_row && i + 1 < rows)
        add_crossings(found, radii, rho(i, j), rho(i + 1, j), false, i * step_px, j * step_px,
                      step_px);
    }
  }
  return found;
}

/// Numbers the runs: stations of one ring that lie next to each other along the lattice.
void number_runs(std::vector<RingStation>& stations, double step) {
  int run = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0 && (stations[i].ring != stations[i - 1].ring ||
                  (stations[i].place - stations[i - 1].place).norm() > 4.0 * step))
      ++run;
    stations[i].run = run;
  }
}

}  // namespace

std::vector<RingStation> ring_lines(const GrowthSolid& solid, const Cut& cut, const Extent& extent,
                                    int step_px, double least_slope) {
  const Eigen::Vector3d right(cut.right[0], cut.right[1], cut.right[2]),
      up(cut.up[0], cut.up[1], cut.up[2]);
  const auto found = crossings(solid, cut, extent, step_px);
  std::vector<RingStation> stations(found.size());
  std::vector<std::tuple<std::size_t, bool, bool, double>> keys(found.size());
  for_each_index(int(found.size()), [&](int index) {
    const auto i = std::size_t(index);
    RingStation& station = stations[i];
    station.ring = found[i].ring;
    station.place = extent.place(found[i].row, found[i].col);
    SolidLocal local = local_of(solid, cut.at(station.place.x(), station.place.y()), false);
    Eigen::Vector2d slope(local.gradient.dot(right), local.gradient.dot(up));
    // Between the places of the lattice rho is nearly straight: one step of Newton is left.
    const double off =
        (solid.radii[station.ring] - local.rho) / std::max(slope.squaredNorm(), 1e-9);
    if (std::abs(off) * slope.norm() < 2.0 * step_px * extent.pitch) station.place += off * slope;
    local = local_of(solid, cut.at(station.place.x(), station.place.y()));
    slope = {local.gradient.dot(right), local.gradient.dot(up)};
    station.slope = slope.norm();
    station.normal = slope / std::max(station.slope, 1e-12);
    station.sigma = ring_sigma(solid, local, station.ring);
    const bool outward = (found[i].along_row ? slope.x() : slope.y()) > 0.0;
    const double along = found[i].along_row ? found[i].row : found[i].col;
    keys[i] = {station.ring, found[i].along_row, outward, along};
  });
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (stations[i].slope >= least_slope) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<RingStation> sorted;
  for (const std::size_t i : order) sorted.push_back(stations[i]);
  number_runs(sorted, step_px * extent.pitch);
  return sorted;
}

}  // namespace hada
