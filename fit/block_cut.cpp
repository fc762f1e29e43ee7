#include "fit/block_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hada {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int slopes_across = 12;       // places along the longer side of a cut
constexpr double least_upright = 0.25;  // cosine to the cut of a stem whose fibres can lean on it
constexpr double out_of_plane = 0.01;   // slope that simplest growth may miss

/// The fibre gradient G of `wood` at a height and a year, and how sure it is.
Known gradient_of(const Wood<>& wood, const Wood<>& sigma, double z) {
  const double angle = turn * z / wood.wave_length_mm + wood.wave_phase_rad;
  double value = wood.spiral, variance = sigma.spiral * sigma.spiral;
  if (wood.wave_amplitude > 0.0) {
    value += wood.wave_amplitude * std::sin(angle);
    variance += std::pow(sigma.wave_amplitude * std::sin(angle), 2) +
                std::pow(wood.wave_amplitude * std::cos(angle) * sigma.wave_phase_rad, 2);
  }
  return {value, std::sqrt(variance)};
}

CutSlope slope_at(const BlockFit& block, const Cut& cut, const Eigen::Vector2d& place) {
  const StemVector at = cut.at(place.x(), place.y());
  const Known turning = gradient_of(block.wood.material, block.wood.sigma, at[2]);
  const auto slope_of = [&](const GrowthSolid& solid, double by) {
    return fibre_slope(solid, cut, place, turning.value + by);
  };
  constexpr double step = 1e-3;
  const double slope = slope_of(block.solid, 0.0);
  const double by_turning = (slope_of(block.solid, step) - slope) / step;
  // Fibres stay on their ring: what is not known of lean and taper is not known of them.
  Eigen::Vector3d by_lean;
  for (Eigen::Index k = 0; k < 3; ++k) {
    GrowthSolid moved = block.solid;
    (k < 2 ? moved.lean[k] : moved.taper) += step;
    by_lean[k] = (slope_of(moved, 0.0) - slope) / step;
  }
  const double leaning = by_lean.dot(block.solid.covariance.block<3, 3>(2, 2) * by_lean);
  const double variance = std::pow(by_turning * turning.sigma, 2) + std::max(leaning, 0.0);
  return {place, {slope, std::hypot(std::sqrt(variance), out_of_plane)}};
}

}  // namespace

CutPrediction predicted(const BlockFit& block, const Cut& cut, const Extent& extent, int step_px) {
  CutPrediction result{cut, extent, ring_lines(block.solid, cut, extent, step_px), {}, {}, {}};
  for (RingStation& station : result.rings)
    station.sigma =
        std::hypot(station.sigma, block.solid.radii_loose[station.ring]) / station.slope;

  if (std::abs(cut.up[2]) > least_upright) {
    const double step = std::max(extent.width(), extent.height()) / slopes_across;
    const int rows = std::max(1, int(extent.height() / step)),
              cols = std::max(1, int(extent.width() / step));
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < cols; ++j) {
        const Eigen::Vector2d place(((j + 0.5) / cols - 0.5) * extent.width(),
                                    (0.5 - (i + 0.5) / rows) * extent.height());
        result.slopes.push_back(slope_at(block, cut, place));
        result.mean_slope.value += result.slopes.back().slope.value / (rows * cols);
        result.mean_slope.sigma += result.slopes.back().slope.sigma / (rows * cols);
      }
    }
  }

  Wood<> wood = block.wood.material;
  wood.cut_origin_mm.assign(cut.origin.begin(), cut.origin.end());
  wood.cut_right.assign(cut.right.begin(), cut.right.end());
  wood.cut_up.assign(cut.up.begin(), cut.up.end());
  result.picture = surface_of(wood, extent, 1, block.solid.ripples);
  return result;
}

}  // namespace hada
