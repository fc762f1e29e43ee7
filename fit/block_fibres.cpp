#include "fit/block_fibres.h"

#include <cmath>

#include <Eigen/LU>

#include "core/error.h"
#include "fit/face_grain.h"
#include "fit/wood.h"

namespace hada {
namespace {

constexpr double upright = 0.7;  // cosine to the stem of what is up on a face along it

/// The gradient G that makes fibres lean as a streak of a face does; NaN where the face is not as
/// tangential as `least`.
double turning_of(const GrowthSolid& solid, const Cut& cut, const Streak& streak, double least) {
  const double level = fibre_slope(solid, cut, streak.place, 0.0);
  constexpr double step = 1e-3;
  const double by_turning = (fibre_slope(solid, cut, streak.place, step) - level) / step;
  return std::abs(by_turning) < least ? std::nan("") : (streak.slope - level) / by_turning;
}

}  // namespace

Eigen::Vector2d fibre_lean(const std::vector<PlacedFace>& faces) {
  constexpr double usual = 0.1;  // of a face that shows nothing
  Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() / (usual * usual);
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const PlacedFace& face : faces) {
    if (std::abs(face.cut.up[2]) < upright) continue;
    try {
      const FaceGrain grain = face_grain(face.surface);
      const Eigen::Vector2d across(face.cut.right[0], face.cut.right[1]);
      const double sigma = std::max(grain.gradient.sigma, 0.01);
      const double slope = grain.gradient.value * (face.cut.up[2] > 0.0 ? 1.0 : -1.0);
      normal += across * across.transpose() / (sigma * sigma);
      right += across * slope / (sigma * sigma);
    } catch (const Error&) {  // too few fibres can be seen: others may show more
    }
  }
  return normal.inverse() * right;
}

void add_turning(Fit<Wood<>>& wood, const GrowthSolid& solid,
                 const std::vector<PlacedFace>& faces) {
  const PlacedFace* best = nullptr;
  FaceGrain grain;
  for (const double least : {0.94, 0.8, 0.6}) {  // cosine to the direction around the stem
    for (const PlacedFace& face : faces) {
      if (std::abs(face.cut.up[2]) < upright) continue;
      try {
        const FaceGrain one = face_grain(face.surface, [&](const Streak& streak) {
          return turning_of(solid, face.cut, streak, least);
        });
        if (best && one.parts <= grain.parts) continue;
        best = &face;
        grain = one;
      } catch (const Error&) {  // too few parts: another face may show more
      }
    }
    if (best) break;
  }
  if (!best) {
    wood.remarks.push_back(
        "No face shows fibres where it is tangential: how they turn around the stem is not known.");
    return;
  }
  if (grain.kind == FaceGrain::Kind::wavy) {  // counted from the height of z = 0, upward
    const double height = 2.0 * M_PI * best->cut.origin[2] / grain.length.value;
    if (best->cut.up[2] < 0.0) grain.phase.value = M_PI - grain.phase.value;
    grain.phase.value = std::remainder(grain.phase.value - height, 2.0 * M_PI);
  }
  add_face(wood, grain);
}

}  // namespace hada
