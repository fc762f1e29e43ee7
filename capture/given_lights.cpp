#include "capture/given_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "capture/chrome_sphere.h"
#include "capture/matte_sphere.h"
#include "capture/sphere_geometry.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double notable = 1.5 * degree;  // normals turn by about as much as lights do
constexpr double certain = 4.0;           // sigma

// Root mean square angle between what a sphere sees and what was given, and how well it is known.
struct Difference {
  double angle = 0.0;
  double sigma = 0.0;
};

std::optional<Difference> difference(const SphereReading& reading, const std::vector<Light>& lights,
                                     const Camera& camera) {
  const Eigen::Vector3d place = in_space(reading.sphere, camera).center;
  double squares = 0.0, variance = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const Light& seen = reading.lights[k];
    if (!std::isfinite(seen.direction_sigma)) continue;
    const Eigen::Vector3d given = lights[k].position ? (*lights[k].position - place).normalized()
                                                     : lights[k].direction.normalized();
    const double angle = std::atan2(given.cross(seen.direction).norm(), given.dot(seen.direction));
    squares += angle * angle;
    variance += seen.direction_sigma * seen.direction_sigma;
    ++count;
  }
  if (count == 0) return {};
  return Difference{std::sqrt(squares / count), std::sqrt(variance / count)};
}

}  // namespace

std::vector<std::string> remarks_on_given_lights(const Photographs& photographs,
                                                 const std::vector<Light>& lights,
                                                 const std::vector<Sphere>& spheres) {
  std::vector<std::string> remarks;
  if (spheres.empty()) return remarks;
  std::optional<Photographs> made;  // large pictures are only copied where values change
  if (!is_linearized(photographs)) made = linearized(copy_of(photographs));
  const Photographs& linear = made ? *made : photographs;
  for (const Sphere& sphere : spheres) {
    const bool matte = sphere.kind == SphereKind::matte;
    const SphereReading reading = matte ? read_matte_sphere(linear, sharpened_matte(linear, sphere))
                                        : read_chrome_sphere(linear, sphere);
    const auto found = difference(reading, lights, photographs.camera);
    if (!found || found->angle < std::max(notable, certain * found->sigma)) continue;
    remarks.push_back(fmt::format(
        "The {} sphere at ({:.0f}, {:.0f}) sees the lights {:.1f} deg (root mean square) from "
        "where "
        "they are said to be: they belong to other pictures, stand in another order, or the rig "
        "was moved; leave them away, and they are read off the spheres.",
        matte ? "matte" : "chrome", sphere.center_px.x(), sphere.center_px.y(),
        found->angle / degree));
  }
  return remarks;
}

}  // namespace hada
