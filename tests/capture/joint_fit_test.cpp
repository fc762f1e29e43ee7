#include "capture/joint_fit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "made_evidence.h"

namespace hada {
namespace {

// Lights turned by about four degrees, equal strengths, a ball that is 0.02 mm off: a rough start.
JointState rough_start(const MadeEvidence& made, double inverse_distance) {
  JointState start = made.truth;
  for (std::size_t k = 0; k < start.lights.size(); ++k) {
    Eigen::Vector3d direction = vector_of(start.lights[k].direction.data());
    direction += 0.07 * Eigen::Vector3d(gaussian(5, 3 * k), gaussian(5, 3 * k + 1), 0.0);
    direction.normalize();
    start.lights[k].direction = {direction.x(), direction.y(), direction.z()};
    start.lights[k].log_strength = 0.0;
    start.lights[k].inverse_distance = inverse_distance;
  }
  start.spheres[0].place[0] += 0.02;
  start.spheres[0].surface = {std::log(0.6), 0.5};
  return start;
}

double worst_error_deg(const JointState& found, const JointState& truth,
                       const Eigen::Vector3d& point) {
  double worst = 0.0;
  for (std::size_t k = 0; k < truth.lights.size(); ++k) {
    worst = std::max(
        worst, angle_deg(arriving_at(found.lights[k], point), arriving_at(truth.lights[k], point)));
  }
  return worst;
}

TEST(JointFit, FindsDistantLightsFromARoughStart) {
  constexpr double noise = 0.001;
  const MadeEvidence made = made_evidence(noise, 0.0, 1);
  JointState state = rough_start(made, 0.0);
  descend(state, made.evidence, LampModel::distant, 3);
  // A normal of the ball is known to the outline's 0.01 / 5, of which the shading itself leaves
  // about half: 0.057 degrees; 270 values with a noise of 0.2 % of a full light add 0.002 /
  // sqrt(270 / 3), 0.012. The worst of six lies below three of them.
  EXPECT_LT(worst_error_deg(state, made.truth, made.evidence.sheet.center), 0.17);
  EXPECT_NEAR(state.spheres[0].surface[1], 0.4, 0.05);
  EXPECT_NEAR(state.spheres[0].sigma, noise, 0.2 * noise);
  EXPECT_NEAR(state.sheet_sigma, noise, 0.2 * noise);
}

TEST(JointFit, FindsNearLampsAndHowFarTheyAre) {
  const MadeEvidence made = made_evidence(0.001, 1.0 / 200.0, 2);
  JointState state = rough_start(made, 0.001);
  descend(state, made.evidence, LampModel::near, 4);
  EXPECT_LT(worst_error_deg(state, made.truth, made.evidence.sheet.center), 0.2);
  for (const LightState& light : state.lights) {
    // The fall-off over 40 mm at 200 mm is 40 %; 0.1 % of noise on hundreds of values tells the
    // distance to a few per cent.
    EXPECT_NEAR(1.0 / light.inverse_distance, 200.0, 20.0);
  }
}

TEST(JointFit, SaysWhatOneSphereAloneSees) {
  const MadeEvidence made = made_evidence(0.001, 0.0, 3);
  JointState state = made.truth;
  descend(state, made.evidence, LampModel::distant, 2);
  std::vector<std::vector<Light>> seen(2, std::vector<Light>(6));
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector3d own = own_direction(state, made.evidence, 0, k);
    const Eigen::Vector3d joint = vector_of(state.lights[k].direction.data());
    EXPECT_LT(angle_deg(own, joint), 0.05);
    seen[0][k].direction = own;
    seen[1][k].direction =
        Eigen::AngleAxisd(2.0 * degree, own.unitOrthogonal()).toRotationMatrix() * own;
  }
  state.spheres.push_back(state.spheres[0]);
  // Two degrees, by what the first differs from the joint fit, in length instead of angle.
  EXPECT_NEAR(disagreement(state, seen) / degree, 2.0, 0.01);
}

}  // namespace
}  // namespace hada
