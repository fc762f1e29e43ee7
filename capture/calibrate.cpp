#include "capture/calibrate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "capture/ambient.h"
#include "capture/chrome_sphere.h"
#include "capture/diagnose.h"
#include "capture/evidence.h"
#include "capture/find_spheres.h"
#include "capture/lamp_colours.h"
#include "capture/lit_disc.h"
#include "capture/matte_sphere.h"
#include "capture/refine_lights.h"
#include "capture/tone_curve.h"
#include "core/error.h"
#include "core/quantile.h"

namespace hada {
namespace {

// The misfit of every matte sphere in every picture if they are taken as linear or as sRGB.
std::vector<double> matte_misfits(const Photographs& photographs,
                                  const std::vector<Sphere>& spheres, bool as_linear) {
  Photographs read = copy_of(photographs);
  read.linear = as_linear;
  const Photographs linear = linearized(std::move(read));
  std::vector<double> misfits;
  for (const Sphere& sphere : spheres) {
    if (sphere.kind != SphereKind::matte) continue;
    for (std::size_t k = 0; k < linear.images.size(); ++k) {
      const MatteShading shading =
          matte_shading(luminance(linear.images[k]), linear.saturated[k], linear.camera, sphere);
      misfits.push_back(shading.misfit);
    }
  }
  return misfits;
}

// Settles the encoding on the matte spheres where the files do not.
void decide_encoding(const Photographs& photographs, const std::vector<Sphere>& spheres,
                     Calibration& calibration) {
  calibration.linear = photographs.linear;
  calibration.encoding_known = photographs.encoding_known;
  const bool has_matte = std::any_of(spheres.begin(), spheres.end(),
                                     [](const Sphere& s) { return s.kind == SphereKind::matte; });
  if (!has_matte || photographs.encoding_known) return;
  const auto as_linear = matte_misfits(photographs, spheres, true);
  const auto as_srgb = matte_misfits(photographs, spheres, false);
  double linear = 0.0;
  double srgb = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < as_linear.size(); ++i) {
    // A disc that is not shaded under either reading lies in shadow, and says nothing.
    if (std::min(as_linear[i], as_srgb[i]) > hopeless_misfit) continue;
    linear += as_linear[i];
    srgb += as_srgb[i];
    count += 1.0;
  }
  if (count == 0.0) return;
  calibration.linear = linear <= srgb;
  calibration.encoding_known = true;
  calibration.remarks.push_back(fmt::format(
      "The matte sphere says that the pictures are {} (its shading is off by {:.1f} % that way, "
      "by {:.1f} % the other).",
      calibration.linear ? "linear" : "sRGB", 100.0 * std::min(linear, srgb) / count,
      100.0 * std::max(linear, srgb) / count));
}

// Whether there is a sphere if the pictures are read the other way.
bool shows_spheres_otherwise(const Photographs& given) {
  Photographs other = copy_of(given);
  other.linear = !given.linear;
  return !find_spheres(other).spheres.empty();
}

// As the first matte sphere shows it that sees it, else like the usual light there; 1 if there is
// none.
double grey_strength(const std::vector<SphereReading>& readings, std::size_t k) {
  double usual = 1.0;
  for (auto reading = readings.rbegin(); reading != readings.rend(); ++reading) {
    if (reading->sphere.kind != SphereKind::matte) continue;
    std::vector<double> seen;
    for (const Light& light : reading->lights) {
      if (is_seen(light)) seen.push_back(light.strength.mean());
    }
    if (!seen.empty()) usual = median(std::move(seen));
  }
  for (const SphereReading& reading : readings) {
    if (reading.sphere.kind != SphereKind::matte || !is_seen(reading.lights[k])) continue;
    return reading.lights[k].strength.mean();
  }
  return usual;
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
  light.strength.setConstant(grey_strength(readings, k));
  light.direction = direction.normalized();
  light.direction_sigma = weight_sum > 0.0 ? std::sqrt(1.0 / weight_sum) : HUGE_VAL;
  return light;
}

// The pictures with linear values, as far as the calibration knows what that takes.
Photographs read_linear(const Photographs& given, const Calibration& calibration) {
  Photographs read = copy_of(given);
  read.linear = calibration.linear;
  read.ambient_light = calibration.ambient_light;
  return linearized(std::move(read));
}

std::vector<SphereReading> read_spheres(const Photographs& linear,
                                        const std::vector<Sphere>& spheres) {
  std::vector<SphereReading> readings;
  for (const Sphere& sphere : spheres) {
    readings.push_back(sphere.kind == SphereKind::matte
                           ? read_matte_sphere(linear, sharpened_matte(linear, sphere))
                           : read_chrome_sphere(linear, sphere));
  }
  leave_out_shadowed(linear, readings);
  return readings;
}

// What matte spheres show in all pictures where no lamp reaches, and that it was taken off.
void take_ambient(const Photographs& linear, Calibration& calibration) {
  const auto& readings = calibration.readings;
  if (std::none_of(readings.begin(), readings.end(), shows_ambient)) return;
  const auto all = evidence(linear, readings, lamp_colours(linear, readings));
  calibration.ambient_light = ambient_light(all, readings, linear.camera);
  if (calibration.ambient_light.isZero()) return;
  const auto matte = std::find_if(readings.begin(), readings.end(), [](const SphereReading& r) {
    return r.sphere.kind == SphereKind::matte;
  });
  calibration.remarks.push_back(
      remark_on_ambient(grey_of(calibration.ambient_light) / full_light(*matte)));
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
  if (!is_linearized(given) || !calibration.linear) made = read_linear(given, calibration);
  calibration.readings = read_spheres(made ? *made : given, found.spheres);
  take_ambient(made ? *made : given, calibration);
  if (!calibration.ambient_light.isZero()) {
    made = read_linear(given, calibration);
    calibration.readings = read_spheres(*made, found.spheres);
  }
  const Photographs& linear = made ? *made : given;
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    Light light = combined(calibration.readings, k);
    if (!is_seen(light)) {
      throw Error(linear.file.pictures[k].file.string() +
                  ": its light is seen on no sphere; leave the picture out or light the sphere");
    }
    calibration.lights.push_back(light);
  }
  const double ambient = grey_of(calibration.ambient_light);
  const auto colours = lamp_colours(linear, calibration.readings);
  const auto refined =
      refined_lights(linear, calibration.readings, calibration.lights, colours, ambient);
  if (ambient > 0.0) calibration.ambient_light *= 1.0 + refined.sheet_ambient / ambient;
  calibration.lights = refined.lights;
  for (std::size_t s = 0; s < calibration.readings.size(); ++s) {
    calibration.readings[s].lights = refined.seen[s];
  }
  if (!refined.sample_believed) {
    calibration.remarks.push_back(
        "What lies beside the spheres is not shaded as a matte sample is under the lights that the "
        "spheres see, so that the lights were read off the spheres alone: say where the sample is "
        "(\"sample_box_px\" or \"mask\" in capture.json), or expose more.");
  }
  calibration.errors = refined.errors;
  calibration.strengths_measured = refined.strengths_measured;
  calibration.sample_believed = refined.sample_believed;
  calibration.disagreement = refined.disagreement;
  for (const auto& remarks :
       {remarks_on_spheres(linear, calibration), remarks_on_curve(linear, calibration),
        remarks_on_lights(calibration.lights)}) {
    calibration.remarks.insert(calibration.remarks.end(), remarks.begin(), remarks.end());
  }
  return calibration;
}

}  // namespace hada
