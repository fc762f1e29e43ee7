#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "capture/evidence.h"
#include "core/sphere.h"

namespace hada {

/// The unknowns of a joint fit, as the solver moves them.
struct LightState {
  std::array<double, 3> direction{0.0, 0.0, 1.0};  // unit, from the origin of the frame
  double log_strength = 0.0;                       // at the origin
  double inverse_distance = 0.0;                   // of the lamp from the origin; 0: distant
};

struct SphereState {
  std::array<double, 3> place{0.0, 0.0, 1.0};  // x, y of the centre, radius
  std::array<double, 3> prior{0.0, 0.0, 1.0};  // where its outline puts it
  double prior_sigma = 1.0;
  std::array<double, 2> surface{0.0, 0.5};  // log value of a full light; reflectance
  std::vector<double> ambient;              // of each picture
  double sigma = 1.0;  // of a value (matte), or of a mirrored direction (chrome, radians)
};

struct JointState {
  std::vector<LightState> lights;
  std::vector<SphereState> spheres;
  std::vector<std::array<double, 4>> sheet;  // albedo times normal, and height, at each point
  double sheet_sigma = 1.0;
  double mirror_weight = 1.0;        // of mirrors' highlights and outlines beside the rest
  double sheet_ambient = 0.0;        // what all of the sheet shows without a lamp
  double sheet_ambient_sigma = 0.0;  // how large that may be; 0: there is none
  double table = 0.0;                // height of what the spheres rest on; the sheet lies at z = 0
  double eye = 0.0;                  // height of the camera; 0: orthographic
  double strength_sigma = 0.5;       // spread of the logarithms of the strengths
  double cost = 0.0;  // half the sum of squares, robust, at the end of the last descent
};

/// What arrives from a light at a point, its strength included.
Eigen::Vector3d arriving_at(const LightState& light, const Eigen::Vector3d& point);

enum class LampModel { distant, near };

/// Where a joint fit begins: the readings combined, the sheet solved under them.
JointState first_state(const Evidence& evidence, const std::vector<SphereReading>& readings,
                       const std::vector<Light>& lights, const Camera& camera);

/// Moves the whole state downhill on all evidence at once; noise levels and ambient light are made
/// anew from the residuals between `rounds` descents.
void descend(JointState& state, const Evidence& evidence, LampModel model, int rounds);

/// The direction of a light as one sphere sees it from its place, everything else as it was found.
Eigen::Vector3d own_direction(const JointState& state, const Evidence& evidence, std::size_t sphere,
                              std::size_t light);

/// The mean angle by which two spheres differ over a light, radians, beyond what their places
/// explain. seen  own directions by sphere and light; direction_sigma infinite: not seen
double disagreement(const JointState& state, const std::vector<std::vector<Light>>& seen);

}  // namespace hada
