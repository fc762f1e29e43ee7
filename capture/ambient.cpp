#include "capture/ambient.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "capture/sphere_geometry.h"
#include "core/image.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double least_share = 0.002;  // of a full light: less does not turn a light by 0.1 degrees
constexpr double thrown_doubt = 0.5;   // the part of thrown light that its model may miss
constexpr std::size_t all_pictures = std::size_t(-1);

std::vector<double> greys_of(const std::vector<Eigen::Vector3d>& dark) {
  std::vector<double> greys;
  for (const auto& channels : dark) {
    if (channels.allFinite()) greys.push_back(grey_of(channels));
  }
  return greys;
}

// The mean of what the pictures show, scaled to a grey value of 1.
Eigen::Vector3d colour_of(const std::vector<Eigen::Vector3d>& dark) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& channels : dark) {
    if (channels.allFinite()) sum += channels;
  }
  return sum / grey_of(sum);
}

struct DarkPoint {
  double thrown;
  double value;
  std::size_t picture;
};

// The points of a matte sphere that look away from the lamp of their picture.
std::vector<DarkPoint> dark_points(const MatteEvidence& seen, const SphereReading& reading,
                                   const Camera& camera) {
  const SphereInSpace in_place = in_space(reading.sphere, camera);
  std::vector<DarkPoint> points;
  for (std::size_t i = 0; i < seen.rays.size(); ++i) {
    const auto hit = first_hit<double>(seen.rays[i], in_place.center, in_place.radius);
    if (!hit) continue;
    for (std::size_t k = 0; k < reading.lights.size(); ++k) {
      constexpr double turned_away = -0.1;
      const double value = seen.values[k][i];
      if (std::isnan(value) || hit->normal.dot(reading.lights[k].direction) > turned_away) continue;
      points.push_back({seen.thrown[k][i], value, k});
    }
  }
  return points;
}

// The line through dark points: what is there without thrown light, and the share thrown back.
struct DarkLine {
  double ambient = 0.0;
  double reflectance = 0.0;
};

DarkLine line_through(const std::vector<DarkPoint>& points, std::size_t without_picture) {
  DarkLine line;
  double width = HUGE_VAL;  // of Tukey's weights
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
    std::vector<double> sizes;
    for (const DarkPoint& point : points) {
      if (point.picture == without_picture) continue;
      const double residual = point.value - line.ambient - line.reflectance * point.thrown;
      sizes.push_back(std::abs(residual));
      const double off = std::min(1.0, std::abs(residual) / width);
      const double weight = (1.0 - off * off) * (1.0 - off * off);
      n += weight;
      t += weight * point.thrown;
      v += weight * point.value;
      tt += weight * point.thrown * point.thrown;
      tv += weight * point.thrown * point.value;
    }
    if (!(n > 0.0)) return line;
    const double spread = tt - t * t / n;
    line.reflectance = spread > 0.0 ? std::clamp((tv - t * v / n) / spread, 0.0, 1.0) : 0.0;
    line.ambient = (v - line.reflectance * t) / n;
    width = std::max(4.685 * 1.4826 * median(std::move(sizes)), 1e-9);
  }
  return line;
}

// What one sphere shows in every picture, in grey; 0 where that cannot be told from nothing.
double ambient_on(const MatteEvidence& seen, const SphereReading& reading, const Camera& camera) {
  const auto points = dark_points(seen, reading, camera);
  std::vector<double> dark = greys_of(reading.dark);
  constexpr std::size_t enough = 30;
  if (points.size() < enough || dark.empty()) return 0.0;
  std::vector<double> thrown;
  for (const DarkPoint& point : points) thrown.push_back(point.thrown);
  const DarkLine line = line_through(points, all_pictures);
  double least = line.ambient;  // whichever picture is left out
  for (std::size_t k = 0; k < reading.lights.size(); ++k) {
    least = std::min(least, line_through(points, k).ambient);
  }
  const double ambient = std::min(line.ambient, median(std::move(dark)));
  const double notable = std::max(least_share * full_light(reading),
                                  thrown_doubt * line.reflectance * median(std::move(thrown)));
  return std::min(ambient, least) > notable ? ambient : 0.0;
}

}  // namespace

double grey_of(const Eigen::Vector3d& channels) {
  return Eigen::Vector3d(luminance_weight[0], luminance_weight[1], luminance_weight[2])
      .dot(channels);
}

bool shows_ambient(const SphereReading& reading) {
  std::vector<double> dark = greys_of(reading.dark);
  return !dark.empty() && median(std::move(dark)) > least_share * full_light(reading);
}

double full_light(const SphereReading& reading) {
  std::vector<double> strengths;
  for (const Light& light : reading.lights) {
    if (std::isfinite(light.direction_sigma)) strengths.push_back(grey_of(light.strength));
  }
  return strengths.empty() ? 0.0 : median(std::move(strengths));
}

Eigen::Vector3d ambient_light(const Evidence& evidence, const std::vector<SphereReading>& readings,
                              const Camera& camera) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const MatteEvidence& seen : evidence.matte) {
    const SphereReading& reading = readings[seen.sphere];
    const double grey = ambient_on(seen, reading, camera);
    if (grey == 0.0) return Eigen::Vector3d::Zero();
    sum += grey * colour_of(reading.dark) / double(evidence.matte.size());
  }
  return sum;
}

std::string remark_on_ambient(double share) {
  return fmt::format(
      "The dark side of the matte sphere shows {:.1f} % of a full light: as much was taken off all "
      "pictures; take a picture with all lamps off (\"ambient\" in capture.json) to be exact.",
      100.0 * share);
}

}  // namespace hada
