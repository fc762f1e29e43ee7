#include "capture/agreement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "capture/sphere_geometry.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// What a sphere says of a light, less what the lights that were agreed on say at its place.
struct Departure {
  Eigen::Vector2d place;
  Eigen::Vector3d off;
};

std::vector<Departure> departures(const Calibration& calibration, const Camera& camera,
                                  std::size_t k) {
  const Light& light = calibration.lights[k];
  std::vector<Departure> all;
  for (const SphereReading& reading : calibration.readings) {
    const Light& seen = reading.lights[k];
    if (!std::isfinite(seen.direction_sigma)) continue;
    const Eigen::Vector3d center = in_space(reading.sphere, camera).center;
    const Eigen::Vector3d expected =
        light.position ? Eigen::Vector3d(*light.position - center).normalized() : light.direction;
    all.push_back({center.head<2>(), seen.direction - expected});
  }
  return all;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

std::string on_average(double angle, const Calibration& calibration, const Camera& camera) {
  const auto distance = distance_that_explains(calibration, camera);
  const std::string cause =
      distance ? fmt::format(
                     " They differ as they do under a camera about {:.0f} {} away: if yours is "
                     "that near, give \"camera\" with its distance in capture.json.",
                     *distance, name_of(camera.extent.unit))
               : "";
  return fmt::format(
             "The spheres disagree by {:.1f} degrees on average: one may be no sphere, may have "
             "moved, or its outline is off; look at them in the report.",
             angle / degree) +
         cause;
}

}  // namespace

std::vector<std::optional<double>> disagreements(const Calibration& calibration,
                                                 const Camera& camera) {
  std::vector<std::optional<double>> widest(calibration.lights.size());
  for (std::size_t k = 0; k < widest.size(); ++k) {
    const auto all = departures(calibration, camera, k);
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        widest[k] = std::max(widest[k].value_or(0.0), (all[a].off - all[b].off).norm());
      }
    }
  }
  return widest;
}

std::optional<double> distance_that_explains(const Calibration& calibration, const Camera& camera) {
  if (camera.model == Camera::Model::perspective) return std::nullopt;
  double along = 0.0;
  double turns = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < calibration.lights.size(); ++k) {
    const auto all = departures(calibration, camera, k);
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        const Eigen::Vector2d apart = all[a].place - all[b].place;
        const Eigen::Vector3d axis(-apart.y(), apart.x(), 0.0);
        const Eigen::Vector3d turn = axis.cross(calibration.lights[k].direction);
        const Eigen::Vector3d difference = all[a].off - all[b].off;
        along += turn.dot(difference);
        turns += turn.squaredNorm();
        total += difference.squaredNorm();
      }
    }
  }
  constexpr double enough = 0.7;
  if (!(along > 0.0) || along * along < enough * total * turns) return std::nullopt;
  return turns / along;
}

std::vector<std::string> remarks_on_agreement(const Calibration& calibration,
                                              const Camera& camera) {
  const auto angles = disagreements(calibration, camera);
  std::vector<double> known;
  for (const auto& angle : angles) {
    if (angle) known.push_back(*angle);
  }
  if (known.empty()) return {};
  const double usual = median(known);
  constexpr double notable = 3.0 * degree;
  constexpr double farther_than_usual = 3.0;
  const double outlying = std::max(notable, farther_than_usual * usual);
  std::vector<std::string> remarks;
  std::vector<double> others;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    if (!angles[k]) continue;
    if (*angles[k] <= outlying) {
      others.push_back(*angles[k]);
      continue;
    }
    remarks.push_back(fmt::format(
        "In {} the spheres disagree by {:.1f} degrees on the light (in most pictures by {:.1f}): "
        "one of them moved, lies in shadow or sees a second lamp there; photograph it again or "
        "leave the picture out.",
        calibration.lights[k].image, *angles[k] / degree, usual / degree));
  }
  const double mean = mean_of(others);
  if (mean > notable) remarks.push_back(on_average(mean, calibration, camera));
  return remarks;
}

}  // namespace hada
