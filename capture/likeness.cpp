#include "capture/likeness.h"

#include <algorithm>
#include <vector>

#include "capture/chrome_sphere.h"
#include "capture/matte_sphere.h"
#include "core/sphere.h"

namespace hada {
namespace {

// A few pictures, spread over the set, are enough to tell what a circle is.
std::vector<std::size_t> probes(std::size_t count) {
  constexpr std::size_t most = 8;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < std::min(most, count); ++i) {
    chosen.push_back(i * count / std::min(most, count));
  }
  return chosen;
}

}  // namespace

double matte_likeness(const Photographs& photographs, const Overview& all, const Circle& circle) {
  const Sphere sphere{SphereKind::matte, circle.center, circle.radius, 0.0, {}};
  std::vector<double> likeness;
  for (const std::size_t k : probes(all.greys.size())) {
    const MatteShading shading =
        matte_shading(all.greys[k], photographs.saturated[k], photographs.camera, sphere, 0.9);
    constexpr double flat = 0.12;  // less spread than any lit sphere has
    constexpr double dim = 0.08;   // of the picture's brightest parts: no sphere, but noise
    const double strength = shading.b.norm();
    const bool sphere_like = shading.spread > flat && strength > dim * all.bright[k] &&
                             shading.b.z() > 0.05 * strength && shading.ambient < 1.5 * strength;
    likeness.push_back(sphere_like ? std::max(0.0, 1.0 - shading.misfit) : 0.0);
  }
  // The lower quartile: nearly every picture must agree.
  std::sort(likeness.begin(), likeness.end());
  return likeness[likeness.size() / 4];
}

double chrome_likeness(const Photographs& photographs, const Overview& all, const Circle& circle) {
  const Sphere sphere{SphereKind::chrome, circle.center, circle.radius, 0.0, {}};
  const auto chosen = probes(all.greys.size());
  int clear = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> places;
  for (const std::size_t k : chosen) {
    const auto spot = highlight(all.greys[k], photographs.saturated[k], photographs.camera, sphere);
    constexpr double prominent = 4.0;
    constexpr double compact = 0.35;   // radians, root mean square: no lamp is wider
    constexpr double brilliant = 0.2;  // of the brightest glint in the picture
    if (!spot || spot->prominence < prominent || spot->width > compact ||
        spot->peak < brilliant * all.glint[k]) {
      continue;
    }
    ++clear;
    places.push_back(spot->center_px);
    mean += spot->center_px;
  }
  if (clear < 2) return 0.0;
  mean /= clear;
  double wander = 0.0;
  for (const auto& place : places) wander += (place - mean).norm() / clear;
  if (chosen.size() > 2 && wander < 0.03 * circle.radius) return 0.0;
  const double share = double(clear) / double(chosen.size());
  return share >= 0.6 ? share : 0.0;
}

}  // namespace hada
