#include "capture/calibrate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "capture/chrome_sphere.h"
#include "capture/diagnose.h"
#include "capture/find_spheres.h"
#include "capture/matte_sphere.h"
#include "capture/refine_lights.h"
#include "capture/tone_curve.h"
#include "core/error.h"

namespace hada {
namespace {

bool is_seen(const Light& light) {
  return std::isfinite(light.direction_sigma);
}

// Mean misfit of the matte spheres if the pictures are taken as linear or as sRGB.
double matte_misfit(const Photographs& photographs, const std::vector<Sphere>& spheres,
                    bool as_linear) {
  Photographs read = copy_of(photographs);
  read.linear = as_linear;
  const Photographs linear = linearized(std::move(read));
  double sum = 0.0;
  int count = 0;
  for (const Sphere& sphere : spheres) {
    if (sphere.kind != SphereKind::matte) continue;
    for (std::size_t k = 0; k < linear.images.size(); ++k) {
      sum += matte_shading(luminance(linear.images[k]), linear.saturated[k], linear.camera, sphere,
                           0.95)
                 .misfit;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

// Settles the encoding on the matte spheres where the files do not.
void decide_encoding(const Photographs& photographs, const std::vector<Sphere>& spheres,
                     Calibration& calibration) {
  calibration.linear = photographs.linear;
  calibration.encoding_known = photographs.encoding_known;
  const bool has_matte = std::any_of(spheres.begin(), spheres.end(),
                                     [](const Sphere& s) { return s.kind == SphereKind::matte; });
  if (!has_matte || photographs.encoding_known) return;
  const double linear = matte_misfit(photographs, spheres, true);
  const double srgb = matte_misfit(photographs, spheres, false);
  calibration.linear = linear <= srgb;
  calibration.encoding_known = true;
  calibration.remarks.push_back(fmt::format(
      "The matte sphere says that the pictures are {} (its shading is off by {:.1f} % that way, "
      "by {:.1f} % the other).",
      calibration.linear ? "linear" : "sRGB", 100.0 * std::min(linear, srgb),
      100.0 * std::max(linear, srgb)));
}

// Whether there is a sphere if the pictures are read the other way.
bool shows_spheres_otherwise(const Photographs& given) {
  Photographs other = copy_of(given);
  other.linear = !given.linear;
  return !find_spheres(other).spheres.empty();
}

// The direction of one light out of what every sphere says of it, weighted by sigma.
Light combined(const std::vector<SphereReading>& readings, std::size_t k) {
  Light light = readings.front().lights[k];
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double weight_sum = 0.0;
  for (const SphereReading& reading : readings) {
    const Light& seen = reading.lights[k];
    if (!is_seen(seen)) continue;
    const double weight = 1.0 / (seen.direction_sigma * seen.direction_sigma + 1e-12);
    direction += weight * seen.direction;
    weight_sum += weight;
  }
  light.strength.setOnes();
  for (const SphereReading& reading : readings) {
    if (reading.sphere.kind != SphereKind::matte || !is_seen(reading.lights[k])) continue;
    light.strength.setConstant(reading.lights[k].strength.mean());
    break;
  }
  light.direction = direction.normalized();
  light.direction_sigma = weight_sum > 0.0 ? std::sqrt(1.0 / weight_sum) : HUGE_VAL;
  return light;
}

// How a light's colour departs from its grey strength, as the first matte sphere that sees every
// light shows it: strength of each channel over that of the grey value. All 1 if there is none.
std::vector<Eigen::Vector3d> colours(const std::vector<SphereReading>& readings,
                                     std::size_t count) {
  std::vector<Eigen::Vector3d> colour(count, Eigen::Vector3d::Ones());
  for (const SphereReading& reading : readings) {
    if (reading.sphere.kind != SphereKind::matte ||
        !std::all_of(reading.lights.begin(), reading.lights.end(), is_seen)) {
      continue;
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < count; ++k) {
      colour[k] = reading.lights[k].strength;
      if (!(colour[k].minCoeff() > 0.0)) {
        throw Error(reading.lights[k].image +
                    ": its light lacks a colour altogether; use white lamps, or grey pictures");
      }
      mean += colour[k] / double(count);
    }
    for (auto& channels : colour) {
      channels = channels.cwiseQuotient(mean);
      channels /= Eigen::Vector3d(luminance_weight[0], luminance_weight[1], luminance_weight[2])
                      .dot(channels);
    }
    break;
  }
  return colour;
}

}  // namespace

Calibration calibrate(const Photographs& given) {
  Calibration calibration;
  const FoundSpheres found = find_spheres(given);
  for (const auto& rejected : found.rejected)
    calibration.remarks.push_back("Rejected " + rejected + ".");
  if (found.spheres.empty()) {
    if (shows_spheres_otherwise(given)) {
      throw Error(fmt::format(
          "{}: no reference sphere found while the pictures are read as {}, but read as {} there "
          "is one; say \"encoding\": \"{}\" in capture.json, or develop without a tone curve",
          given.file.folder.string(), given.linear ? "linear" : "sRGB",
          given.linear ? "sRGB" : "linear", given.linear ? "srgb" : "linear"));
    }
    const std::string why =
        found.rejected.empty() ? std::string("") : " (" + found.rejected.front() + ")";
    throw Error(given.file.folder.string() + ": no reference sphere found" + why +
                "; put a matte or chrome sphere wholly into the frame, or give the lights");
  }
  decide_encoding(given, found.spheres, calibration);
  std::optional<Photographs> made;  // large pictures are only copied where values change
  if (!is_linearized(given) || !calibration.linear) {
    made = copy_of(given);
    made->linear = calibration.linear;
    made = linearized(std::move(*made));
  }
  const Photographs& linear = made ? *made : given;
  for (const Sphere& sphere : found.spheres) {
    calibration.readings.push_back(sphere.kind == SphereKind::matte
                                       ? read_matte_sphere(linear, sharpened_matte(linear, sphere))
                                       : read_chrome_sphere(linear, sphere));
  }
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    Light light = combined(calibration.readings, k);
    if (!is_seen(light)) {
      throw Error(linear.file.pictures[k].file.string() +
                  ": its light is seen on no sphere; leave the picture out or light the sphere");
    }
    calibration.lights.push_back(light);
  }
  const auto refined = refined_lights(linear, calibration.readings, calibration.lights);
  const auto colour = colours(calibration.readings, linear.images.size());
  calibration.lights = refined.lights;
  for (std::size_t k = 0; k < colour.size(); ++k) {
    calibration.lights[k].strength = calibration.lights[k].strength.cwiseProduct(colour[k]);
  }
  for (std::size_t s = 0; s < calibration.readings.size(); ++s) {
    calibration.readings[s].lights = refined.seen[s];
  }
  calibration.errors = refined.errors;
  calibration.strengths_measured = refined.strengths_measured;
  calibration.disagreement = refined.disagreement;
  for (const auto& remarks :
       {remarks_on_spheres(linear, calibration), remarks_on_curve(linear, calibration),
        remarks_on_lights(calibration.lights)}) {
    calibration.remarks.insert(calibration.remarks.end(), remarks.begin(), remarks.end());
  }
  return calibration;
}

}  // namespace hada
