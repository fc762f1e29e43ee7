#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace hada {

enum class SphereKind { matte, chrome };

inline std::string_view name_of(SphereKind kind) {
  return kind == SphereKind::matte ? "matte" : "chrome";
}

/// The outline of a reference sphere in the pictures.
struct Sphere {
  SphereKind kind = SphereKind::matte;
  Eigen::Vector2d center_px{0.0, 0.0};  // (u, v): u right, v down, centre of first pixel (0.5, 0.5)
  double radius_px = 0.0;               // of the circle of the same area as the outline
  double sigma_px = 0.0;                // standard deviation of centre and radius
  std::optional<double> diameter_mm;    // where a person has said it
};

}  // namespace hada
