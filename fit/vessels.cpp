#include "fit/vessels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/quantile.h"
#include "fit/dark_wood.h"
#include "measure/background.h"

namespace hada {
namespace {

constexpr std::size_t fewest = 10;
constexpr double astray = 0.05;  // most of the vessels of a ring-porous wood that lie elsewhere

/// The mask without what lies nearer to its border than `margin`.
Mask clear_of_border(const Mask& mask, int margin) {
  Mask rows = mask, both = mask;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      for (int by = -margin; by <= margin && rows(row, col); ++by)
        if (!mask.contains(row, col + by) || !mask(row, col + by)) rows(row, col) = 0;
    }
  }
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      both(row, col) = rows(row, col);
      for (int by = -margin; by <= margin && both(row, col); ++by)
        if (!rows.contains(row + by, col) || !rows(row + by, col)) both(row, col) = 0;
    }
  }
  return both;
}

/// How far through its ring a place lies: 0 where the ring begins, 1 where it ends, in shares of
/// its area; below 0 if it is in no ring whose both ends are known.
double phase_of(double rho, const std::vector<double>& radii) {
  const auto outer = std::upper_bound(radii.begin(), radii.end(), rho);
  if (outer == radii.begin() || outer == radii.end()) return -1.0;
  const double from = *(outer - 1) * *(outer - 1), to = *outer * *outer;
  return (rho * rho - from) / (to - from);
}

struct Told {
  Porosity porosity = Porosity::diffuse;
  double probability = 1.0;
  double zone = 0.0;  // phase up to which vessels belong to the boundary
};

constexpr double zone_step = 0.02;  // of the phase, between zones that are tried

/// The share of all `phases` that lies below each multiple of the step; a phase lies in [0, 1).
std::vector<double> shares_below(const std::vector<double>& phases) {
  std::vector<double> below(std::size_t(std::lround(1.0 / zone_step)) + 1, 0.0);
  for (const double phase : phases)
    below[std::min(std::size_t(phase / zone_step) + 1, below.size() - 1)] += 1.0;
  for (std::size_t k = 1; k < below.size(); ++k) below[k] += below[k - 1];
  for (double& share : below) share /= double(std::max<std::size_t>(phases.size(), 1));
  return below;
}

/// Three ways to lie in a ring, by the Bayesian information criterion.
///
/// phases  of vessels
/// places  phases of all places where a vessel would have been counted, alike likely if diffuse
Told told(const std::vector<double>& phases, const std::vector<double>& places) {
  const double n = double(phases.size());
  const auto of_vessels = shares_below(phases), of_places = shares_below(places);
  double ring = -HUGE_VAL, both = -HUGE_VAL;
  Told result;
  double ring_zone = 0.0, both_zone = 0.0;
  for (std::size_t k = 2; double(k) * zone_step < 0.71; ++k) {
    const double zone = double(k) * zone_step, room = of_places[k];
    if (room <= 0.0 || room >= 1.0) continue;
    const double inside = n * of_vessels[k];
    const double strict = std::clamp(inside / n, 1.0 - astray, n / (n + 1.0));
    const double mixed = std::min(inside / n, 1.0 - 2.0 * astray);
    const auto likelihood = [&](double p) {
      return inside * std::log(p / room) + (n - inside) * std::log((1.0 - p) / (1.0 - room));
    };
    if (likelihood(strict) > ring) {
      ring = likelihood(strict);
      ring_zone = zone;
    }
    if (mixed > room && likelihood(mixed) > both) {
      both = likelihood(mixed);
      both_zone = zone;
    }
  }
  const double scores[] = {0.0, ring - std::log(n), both - std::log(n)};
  const double best = *std::max_element(std::begin(scores), std::end(scores));
  double sum = 0.0;
  for (const double score : scores) sum += std::exp(score - best);
  result.probability = 1.0 / sum;
  if (scores[1] == best) {
    result.porosity = Porosity::ring;
    result.zone = ring_zone;
  } else if (scores[2] == best) {
    result.porosity = Porosity::both;
    result.zone = both_zone;
  }
  return result;
}

/// Mean radius and standard deviation.
struct Sizes {
  Known mean;
  double sd = 0.0;
};

/// weights  of each radius, by how seldom one like it is seen
Sizes sizes_of(const std::vector<double>& radii, const std::vector<double>& weights, double pitch) {
  constexpr double lattice_px =
      0.06;  // that all radii are off by alike: depth known to 2 %, parting
  double weight = 0.0, squares = 0.0, mean = 0.0, square = 0.0;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    weight += weights[k];
    squares += weights[k] * weights[k];
    mean += weights[k] * radii[k];
  }
  mean /= weight;
  for (std::size_t k = 0; k < radii.size(); ++k)
    square += weights[k] / weight * (radii[k] - mean) * (radii[k] - mean);
  const double sd = std::sqrt(square);
  return {{mean, std::hypot(sd * std::sqrt(squares) / weight, lattice_px * pitch)}, sd};
}

/// Discs thrown anywhere, over each other or not: those that lie alone say how large they are, the
/// share that is dark how many there are (a Boolean model; counting would miss what is covered).
void set_scattered(Vessels& vessels, const std::vector<Disc>& discs, double dark_share, double area,
                   double pitch) {
  std::vector<double> radii;
  for (const Disc& disc : discs) {
    if (disc.alone) radii.push_back(disc.radius * pitch);
  }
  if (radii.size() < fewest) return;
  std::vector<double> weights(radii.size(), 1.0);
  for (int round = 0; round < 4; ++round) {
    const Sizes sizes = sizes_of(radii, weights, pitch);
    vessels.radius = sizes.mean;
    vessels.radius_sd = sizes.sd;
    const double mean = sizes.mean.value, square = mean * mean + sizes.sd * sizes.sd;
    const double density = -std::log(1.0 - dark_share) / (std::numbers::pi * square);
    const double fourth =
        (3.0 * std::pow(sizes.sd, 4) + 6.0 * std::pow(mean * sizes.sd, 2) + std::pow(mean, 4)) /
        (square * square);
    vessels.density = {density, density * std::hypot(std::sqrt(fourth / (density * area)),
                                                     2.0 * sizes.mean.sigma / mean)};
    // A disc lies alone if no centre is nearer than the sum of both radii.
    for (std::size_t k = 0; k < radii.size(); ++k)
      weights[k] = std::exp(density * std::numbers::pi *
                            (std::pow(radii[k] + mean, 2) - std::pow(2.0 * mean, 2)));
  }
}

/// Discs along boundaries, `others` of them by chance; evenly placed, they seldom cover each other.
void set_along_rings(Vessels& vessels, const std::vector<Disc>& discs, double others, double length,
                     double pitch) {
  if (discs.empty() || length <= 0.0) return;
  std::vector<double> all, alone;
  for (const Disc& disc : discs) {
    all.push_back(disc.radius * pitch);
    if (disc.alone) alone.push_back(disc.radius * pitch);
  }
  const double count = double(all.size()), own = std::max(count - others, 1.0);
  if (alone.size() >= fewest) all = std::move(alone);
  const Sizes sizes = sizes_of(all, std::vector<double>(all.size(), 1.0), pitch);
  const double more = others / own;
  vessels.ring_density = {own / length, std::sqrt(count) / length};
  vessels.ring_radius = {sizes.mean.value + more * (sizes.mean.value - vessels.radius.value),
                         sizes.mean.sigma * (1.0 + more)};
}

}  // namespace

std::optional<Vessels> vessels_of(const Surface& surface, const EndGrain& grain) {
  const Extent& extent = surface.extent;
  const GrowthFrame& frame = grain.shape.frame;
  const auto seen = dark_wood(luminance(surface.albedo), grain.wood, frame, extent);
  if (!seen) return std::nullopt;
  std::vector<double> sizes;
  for (const Disc& disc : seen->discs) sizes.push_back(disc.radius);

  const Mask clear = clear_of_border(grain.wood, int(std::ceil(quantile(sizes, 0.95))));
  std::vector<double> radii = grain.shape.radii;
  std::sort(radii.begin(), radii.end());
  Vessels vessels;
  Grid<float> phase_at(extent.rows, extent.cols, -1.0f);  // below 0 where no vessel is counted
  std::vector<double> places;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      if (!clear(row, col)) continue;
      const double phase = phase_of(frame.rho_of(extent.place(row, col)), radii);
      if (phase < 0.0) continue;
      phase_at(row, col) = float(phase);
      places.push_back(phase);
    }
  }
  std::vector<double> phases;
  for (const Disc& disc : seen->discs) {
    const int row = int(std::lround(disc.place.x())), col = int(std::lround(disc.place.y()));
    if (!clear.contains(row, col) || phase_at(row, col) < 0.0f) continue;
    const double phase =
        phase_of(frame.rho_of(extent.place(disc.place.x(), disc.place.y())), radii);
    if (phase < 0.0) continue;
    phases.push_back(phase);
    vessels.discs.push_back(disc);
  }
  if (phases.size() < fewest) return std::nullopt;
  const Told kind = told(phases, places);
  vessels.porosity = kind.porosity;
  vessels.probability = kind.probability;

  // Dark that is part of no disc is a boundary whose brightness the wood nearby does not tell.
  Mask covered(extent.rows, extent.cols, 0);
  for (const Disc& disc : seen->discs) {
    for_pixels_in(disc, 1.0, covered,
                  [&](int row, int col) { covered(row, col) = seen->dark(row, col) >= 0.5f; });
  }
  // Area in the zone along boundaries and beyond it, and the length of these boundaries.
  double zone = 0.0, beyond = 0.0, length = 0.0, darkness = 0.0;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const double phase = double(phase_at(row, col));
      if (phase < 0.0) continue;
      (phase < kind.zone ? zone : beyond) += extent.pitch * extent.pitch;
      if (phase >= kind.zone) {
        if (covered(row, col)) darkness += extent.pitch * extent.pitch;
        continue;
      }
      const Eigen::Vector2d place = extent.place(row, col);
      const auto outer = std::upper_bound(radii.begin(), radii.end(), frame.rho_of(place));
      const double inner = *(outer - 1);
      const double last = std::sqrt(inner * inner + kind.zone * (*outer * *outer - inner * inner));
      // Along the boundary in the picture: a frame that sees no whole turn may stretch its radii.
      const double real = (place - frame.pith).norm();
      length += extent.pitch * extent.pitch / (last - inner) * inner / real;
    }
  }
  std::vector<Disc> near, far;
  for (std::size_t k = 0; k < phases.size(); ++k)
    (phases[k] < kind.zone ? near : far).push_back(vessels.discs[k]);
  if (kind.porosity != Porosity::ring)
    set_scattered(vessels, far, darkness / beyond, beyond, extent.pitch);
  if (kind.porosity != Porosity::diffuse)
    set_along_rings(vessels, near, vessels.density.value * zone, length, extent.pitch);
  vessels.shade = {1.0 - seen->depth,
                   std::max(0.01, seen->scatter / std::sqrt(double(phases.size())))};
  return vessels;
}

}  // namespace hada
