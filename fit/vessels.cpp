#include "fit/vessels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/quantile.h"
#include "fit/absorbance.h"
#include "measure/background.h"

namespace hada {
namespace {

constexpr double least_radius_px = 4.0;
constexpr double least_depth = 0.15;    // of a vessel, beside the brightness of the wood
constexpr double least_contrast = 4.0;  // depth over the scatter of the wood
constexpr double least_piece_px = 2.5;  // radius of what is more than a remnant of taking apart
constexpr std::size_t fewest = 10;
constexpr double sector_px = 150.0;  // along a ring: wood that shares one brightness
constexpr int coarse = 4;            // px, from one to the next, for a first look
constexpr double astray = 0.05;      // most of the vessels of a ring-porous wood that lie elsewhere

/// Pixels of the wood with their effective radius, in px, and the cell whose wood they belong to.
struct Place {
  int row, col;
  std::size_t cell;
};

class Ground {
 public:
  Ground(const Grid<float>& brightness, const EndGrain& grain, const Extent& extent, int step)
      : dark_(extent.rows, extent.cols, std::nanf("")) {
    std::map<std::pair<int, int>, std::size_t> cells;
    for (int row = step / 2; row < extent.rows; row += step) {
      for (int col = step / 2; col < extent.cols; col += step) {
        if (!grain.wood(row, col)) continue;
        const Eigen::Vector2d place = extent.place(row, col);
        const double rho = grain.shape.frame.rho_of(place) / extent.pitch;
        const Eigen::Vector2d arm = place - grain.shape.frame.pith;
        const int ring = int(rho / step);
        const int sectors =
            std::clamp(int(2.0 * std::numbers::pi * rho / (sector_px * step)), 1, 1024);
        const int sector =
            int((std::atan2(arm.y(), arm.x()) / (2.0 * std::numbers::pi) + 0.5) * sectors);
        const auto [at, added] = cells.try_emplace({ring, sector}, cells.size());
        places_.push_back({row, col, at->second});
      }
    }
    ground_.resize(cells.size());
    set_ground(brightness, 0.7, HUGE_VAL);
    for (int round = 0; round < 2; ++round) {
      set_depth();
      set_ground(brightness, 0.5, 0.5 * depth_);
    }
    set_depth();
  }

  double depth() const { return depth_; }
  double scatter() const { return scatter_; }

  /// 0 where there is wood, 1 in vessels, NaN where there is neither.
  Grid<float> dark() const {
    Grid<float> result = dark_;
    for (float& value : result) value /= float(depth_);
    return result;
  }

 private:
  /// A quantile of what is in each cell, of that no darker than `darkest`.
  void set_ground(const Grid<float>& brightness, double share, double darkest) {
    std::vector<std::vector<float>> seen(ground_.size());
    for (const Place& place : places_) {
      if (darkest<HUGE_VAL&& double(dark_(place.row, place.col))> darkest) continue;
      seen[place.cell].push_back(brightness(place.row, place.col));
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!seen[k].empty()) ground_[k] = quantile(std::move(seen[k]), share);
    }
    for (const Place& place : places_)
      dark_(place.row, place.col) =
          1.0f - brightness(place.row, place.col) / std::max(ground_[place.cell], 1e-3f);
  }

  /// Two kinds of pixels, told apart where their means differ most (Otsu 1979).
  void set_depth() {
    constexpr int bins = 128;
    std::vector<double> count(bins, 0.0), sum(bins, 0.0);
    for (const Place& place : places_) {
      const double value = std::clamp(double(dark_(place.row, place.col)), -0.999, 0.999);
      const auto bin = std::size_t((value + 1.0) * 0.5 * bins);
      count[bin] += 1.0;
      sum[bin] += value;
    }
    double all = 0.0, total = 0.0, below = 0.0, below_sum = 0.0, best = 0.0, threshold = 0.0;
    for (std::size_t k = 0; k < bins; ++k) {
      all += count[k];
      total += sum[k];
    }
    for (std::size_t k = 0; k + 1 < bins; ++k) {
      below += count[k];
      below_sum += sum[k];
      if (below <= 0.0 || all - below <= 0.0) continue;
      const double apart = below_sum / below - (total - below_sum) / (all - below);
      const double between = below * (all - below) * apart * apart;
      if (between <= best) continue;
      best = between;
      threshold = 2.0 * double(k + 1) / bins - 1.0;
    }
    std::vector<float> wood, vessels;
    for (const Place& place : places_) {
      const float value = dark_(place.row, place.col);
      (double(value) > threshold ? vessels : wood).push_back(value);
    }
    depth_ = scatter_ = 0.0;
    if (vessels.empty() || wood.empty()) return;
    depth_ = double(median(std::move(vessels)));
    scatter_ = 0.5 * double(quantile(wood, 0.84) - quantile(wood, 0.16));
  }

  std::vector<Place> places_;
  std::vector<float> ground_;
  Grid<float> dark_;
  double depth_ = 0.0, scatter_ = 0.0;
};

bool shows_vessels(const Ground& ground) {
  return ground.depth() > least_depth && ground.depth() > least_contrast * ground.scatter();
}

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

/// Three ways to lie in a ring, by the Bayesian information criterion.
Told told(const std::vector<double>& phases) {
  const double n = double(phases.size());
  double ring = -HUGE_VAL, both = -HUGE_VAL;
  Told result;
  double ring_zone = 0.0, both_zone = 0.0;
  for (double zone = 0.04; zone <= 0.7; zone += 0.02) {
    const double inside =
        double(std::count_if(phases.begin(), phases.end(), [&](double v) { return v < zone; }));
    const double strict = std::clamp(inside / n, 1.0 - astray, n / (n + 1.0));
    const double mixed = std::min(inside / n, 1.0 - 2.0 * astray);
    const auto likelihood = [&](double p) {
      return inside * std::log(p / zone) + (n - inside) * std::log((1.0 - p) / (1.0 - zone));
    };
    if (likelihood(strict) > ring) {
      ring = likelihood(strict);
      ring_zone = zone;
    }
    if (mixed > zone && likelihood(mixed) > both) {
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
  const auto brightness = luminance(surface.albedo);
  if (!shows_vessels(Ground(brightness, grain, extent, coarse))) return std::nullopt;
  const Ground ground(brightness, grain, extent, 1);
  if (!shows_vessels(ground)) return std::nullopt;
  const auto dark = ground.dark();
  auto discs = dark_discs(dark);
  std::erase_if(discs, [](const Disc& disc) { return disc.radius < least_piece_px; });
  std::vector<double> sizes;
  for (const Disc& disc : discs) sizes.push_back(disc.radius);
  if (sizes.size() < fewest || median(sizes) < least_radius_px) return std::nullopt;

  const Mask clear = clear_of_border(grain.wood, int(std::ceil(quantile(sizes, 0.95))));
  std::vector<double> radii = grain.shape.radii;
  std::sort(radii.begin(), radii.end());
  Vessels vessels;
  std::vector<double> phases;
  for (const Disc& disc : discs) {
    const int row = int(std::lround(disc.place.x())), col = int(std::lround(disc.place.y()));
    if (!clear.contains(row, col) || !clear(row, col)) continue;
    const double phase =
        phase_of(grain.shape.frame.rho_of(extent.place(disc.place.x(), disc.place.y())), radii);
    if (phase < 0.0) continue;
    phases.push_back(phase);
    vessels.discs.push_back(disc);
  }
  if (phases.size() < fewest) return std::nullopt;
  const Told kind = told(phases);
  vessels.porosity = kind.porosity;
  vessels.probability = kind.probability;

  // Area in the zone along boundaries and beyond it, and the length of these boundaries.
  double zone = 0.0, beyond = 0.0, length = 0.0, darkness = 0.0;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      if (!clear(row, col)) continue;
      const double rho = grain.shape.frame.rho_of(extent.place(row, col));
      const double phase = phase_of(rho, radii);
      if (phase < 0.0) continue;
      (phase < kind.zone ? zone : beyond) += extent.pitch * extent.pitch;
      if (phase >= kind.zone) {
        if (dark(row, col) >= 0.5f) darkness += extent.pitch * extent.pitch;
        continue;
      }
      const auto outer = std::upper_bound(radii.begin(), radii.end(), rho);
      const double inner = *(outer - 1);
      const double last = std::sqrt(inner * inner + kind.zone * (*outer * *outer - inner * inner));
      length += extent.pitch * extent.pitch / (last - inner) * inner / rho;
    }
  }
  std::vector<Disc> near, far;
  for (std::size_t k = 0; k < phases.size(); ++k)
    (phases[k] < kind.zone ? near : far).push_back(vessels.discs[k]);
  if (kind.porosity != Porosity::ring)
    set_scattered(vessels, far, darkness / beyond, beyond, extent.pitch);
  if (kind.porosity != Porosity::diffuse)
    set_along_rings(vessels, near, vessels.density.value * zone, length, extent.pitch);
  vessels.shade = {1.0 - ground.depth(),
                   std::max(0.01, ground.scatter() / std::sqrt(double(phases.size())))};
  return vessels;
}

}  // namespace hada
