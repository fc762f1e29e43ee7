#include "fit/ring_sightings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/ring_edges.h"

namespace hada {
namespace {

constexpr double step_px = 0.5;        // of the profile across a line
constexpr double margin_px = 6.0;      // of the profile beyond where is searched
constexpr int beside = 9;              // offsets along the line to each side, that are looked at
constexpr double without_pores = 0.7;  // of the values along a line, which pores are darker than
constexpr double with_pores = 0.3;
constexpr double apart_px = 4.0;    // from one to the next, at most
constexpr double bent = 0.2;        // of its length that a line may bend
constexpr double own_share = 0.42;  // of the way to the next ring that is still of this one
constexpr double deviations = 2.5;  // of what is expected, that are searched
constexpr double least_search_px = 2.0;
constexpr double edge_blur_px = 1.6;  // Gaussians: of an edge,
constexpr double step_share = 0.06;   // of the distance between rings: of the step of a ring
constexpr double line_share = 0.12;   // of the distance between rings: of a line
constexpr double faint = 0.3;         // of the usual strength
constexpr double most_search_px = 60.0;

/// Distance in rho from a ring to the nearer of its neighbours.
double room_of(const std::vector<double>& radii, std::size_t ring) {
  const double inner = ring > 0 ? radii[ring] - radii[ring - 1] : radii[ring];
  const double outer = ring + 1 < radii.size() ? radii[ring + 1] - radii[ring] : inner;
  return std::min(inner, outer);
}

/// Across a line, from within to without, a quantile of what lies along it.
class Profile {
 public:
  Profile(const BlockFace& face, const GrowthSolid& solid, const RingStation& station, int half,
          double quantile_kept)
      : values_(std::size_t(2 * half + 1), std::numeric_limits<float>::quiet_NaN()) {
    const double pitch = face.extent.pitch;
    const Eigen::Vector2d along(-station.normal.y(), station.normal.x());
    double far = 1.5 * beside * apart_px * pitch, bend = HUGE_VAL;
    while (std::abs(bend) > bent * far &&
           far > 2.0 * pitch) {  // a parabola follows a line no further
      far *= 0.7;
      bend = 0.5 * (departure(face, solid, station, far * along) +
                    departure(face, solid, station, -far * along));
    }
    std::vector<std::vector<float>> seen(values_.size());
    for (int k = -beside; k <= beside; ++k) {
      const double share = double(k) / beside;
      const Eigen::Vector2d middle =
          station.place + share * far * along + share * share * bend * station.normal;
      for (int i = -half; i <= half; ++i) {
        const float value =
            value_at(face.absorbance, face.wood,
                     face.extent.pixel(middle + i * step_px * pitch * station.normal));
        if (value == value) seen[std::size_t(i + half)].push_back(value);
      }
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (int(seen[i].size()) > beside) values_[i] = quantile(std::move(seen[i]), quantile_kept);
    }
  }

  const std::vector<float>& values() const { return values_; }

 private:
  /// How far, along the normal, the line has left its tangent at `by`.
  static double departure(const BlockFace& face, const GrowthSolid& solid,
                          const RingStation& station, const Eigen::Vector2d& by) {
    const Eigen::Vector2d place = station.place + by;
    const double rho = local_of(solid, face.cut.at(place.x(), place.y()), false).rho;
    const double limit = 0.5 * by.norm();
    return std::clamp((solid.radii[station.ring] - rho) / station.slope, -limit, limit);
  }

  std::vector<float> values_;
};

struct Found {
  double off_px = 0.0;  // outward from the middle of the profile
  double strength = 0.0;
};

/// The highest of `response` within `reach` samples of `middle`, which counts from the middle of
/// the profile; between samples.
Found highest(const std::vector<double>& response, int reach, int middle = 0) {
  const int half = int(response.size()) / 2, from = half + middle;
  Found best;
  for (int i = std::max(1, from - reach); i <= std::min(2 * half - 1, from + reach); ++i) {
    const double here = response[std::size_t(i)], before = response[std::size_t(i - 1)],
                 after = response[std::size_t(i + 1)];
    if (!(here >= before) || !(here > after) || here <= best.strength) continue;
    const double curvature = before - 2.0 * here + after;
    best = {(i - half + (curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0)) * step_px,
            here};
  }
  return best;
}

/// The step of the whole ring first, then where in it the edge is: pores may have sharper edges.
Found edge_in(const std::vector<float>& values, int reach, double blur_px) {
  const Found step = highest(slopes_along(values, step_px, blur_px), reach);
  if (step.strength <= 0.0) return step;
  const double half = double(values.size() / 2);
  const int middle = int(std::lround(step.off_px / step_px));
  const auto fine = slopes_along(values, step_px, edge_blur_px);
  Found found = highest(fine, int(std::ceil(1.5 * blur_px / step_px)), middle);
  if (found.strength <= 0.0) return found;
  found.off_px = (middle_of_rise(values, half + found.off_px / step_px, step_px) - half) * step_px;
  return found;
}

/// A dark line: the second derivative of the profile, smoothed as wide as such lines are.
Found line_in(const std::vector<float>& values, int reach, double blur_px) {
  const auto slopes = slopes_along(values, step_px, blur_px / std::sqrt(2.0));
  const std::vector<float> again(slopes.begin(), slopes.end());
  return highest(slopes_along(again, step_px, blur_px / std::sqrt(2.0)), reach);
}

}  // namespace

std::vector<RingSighting> ring_sightings(const BlockFace& face, std::size_t index,
                                         const GrowthSolid& solid, RingMark mark, double noise) {
  const double pitch = face.extent.pitch;
  const int step = std::max(4, std::min(face.extent.rows, face.extent.cols) / 100);
  const auto stations = ring_lines(solid, face.cut, face.extent, step);
  std::vector<Found> found(stations.size());
  for_each_index(int(stations.size()), [&](int i) {
    const RingStation& station = stations[std::size_t(i)];
    const double room_px = room_of(solid.radii, station.ring) / station.slope / pitch;
    const double sigma_px = station.sigma / station.slope / pitch;
    const double own_px = std::min(own_share * room_px, most_search_px);
    if (deviations * sigma_px > own_px || least_search_px > own_px) return;
    const double search_px =
        std::clamp(deviations * std::hypot(sigma_px, noise / pitch), least_search_px, own_px);
    const double blur_px = mark == RingMark::edge
                               ? std::clamp(step_share * room_px, edge_blur_px, 8.0)
                               : std::clamp(line_share * room_px, 1.2, 12.0);
    const int reach = int(std::ceil(search_px / step_px));
    const int half = reach + int((margin_px + 4.5 * blur_px) / step_px);
    const Profile profile(face, solid, station, half,
                          mark == RingMark::edge ? without_pores : with_pores);
    found[std::size_t(i)] = mark == RingMark::edge ? edge_in(profile.values(), reach, blur_px)
                                                   : line_in(profile.values(), reach, blur_px);
  });
  std::vector<double> strengths;
  for (const Found& one : found) {
    if (one.strength > 0.0) strengths.push_back(one.strength);
  }
  std::vector<RingSighting> sightings;
  if (strengths.empty()) return sightings;
  const double least = faint * median(strengths);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (found[i].strength < least) continue;
    const RingStation& station = stations[i];
    const Eigen::Vector2d place = station.place + found[i].off_px * pitch * station.normal;
    StemVector across;
    for (std::size_t k = 0; k < 3; ++k)
      across[k] = station.normal.x() * face.cut.right[k] + station.normal.y() * face.cut.up[k];
    sightings.push_back(
        {face.cut.at(place.x(), place.y()), index, station.ring, station.run, across});
  }
  return sightings;
}

}  // namespace hada
