#include "capture/light_covariance.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "made_evidence.h"

namespace hada {
namespace {

// The spread of the lights over draws of the noise is what the covariance says it is.
void expect_honest(double inverse_distance, LampModel model) {
  constexpr int draws = 30;
  double squares = 0.0;
  int components = 0;
  for (Seed seed = 1; seed <= draws; ++seed) {
    const MadeEvidence made = made_evidence(0.002, inverse_distance, seed);
    // The outline is drawn, too: the truth lies about the prior with the prior's sigma.
    JointState state = made.truth;
    for (int i = 0; i < 3; ++i) {
      state.spheres[0].prior[i] += state.spheres[0].prior_sigma * gaussian(seed, 100000 + i);
    }
    descend(state, made.evidence, model, 2);
    const Eigen::Vector3d point = made.evidence.sheet.center;
    const Eigen::MatrixXd covariance = arriving_covariance(state, made.evidence, model, point);
    ASSERT_EQ(covariance.rows(), 18);
    double mean = 0.0;
    for (const auto& light : made.truth.lights) mean += arriving_at(light, point).norm() / 6.0;
    for (std::size_t k = 0; k < 6; ++k) {
      const Eigen::Vector3d truth = arriving_at(made.truth.lights[k], point);
      const Eigen::Vector3d found = arriving_at(state.lights[k], point);
      const Eigen::Vector3d off = found.normalized() - truth.normalized();
      const auto at = Eigen::Index(3 * k);
      const Eigen::Matrix3d own = covariance.block<3, 3>(at, at);
      const Eigen::Matrix<double, 2, 3> axes = across(truth.normalized());
      const Eigen::Matrix2d expected =
          axes * own * axes.transpose() * mean * mean / truth.squaredNorm();
      const Eigen::Vector2d seen = axes * off;
      squares += seen.dot(expected.inverse() * seen);
      components += 2;
    }
  }
  // 360 components, of which those of one draw hang together: like 12 independent ones in 30 draws
  // at the best and 3 at the worst, so the mean square is known to sqrt(2 / 90) = 15 %.
  const double z = std::sqrt(squares / components);
  EXPECT_GT(z, 0.75);
  EXPECT_LT(z, 1.25);
}

TEST(LightCovariance, IsHonestForDistantLights) {
  expect_honest(0.0, LampModel::distant);
}

TEST(LightCovariance, IsNotTooSmallForNearLamps) {
  const MadeEvidence made = made_evidence(0.002, 1.0 / 200.0, 4);
  JointState state = made.truth;
  descend(state, made.evidence, LampModel::near, 3);
  const Eigen::Vector3d point = made.evidence.sheet.center;
  const Eigen::MatrixXd covariance =
      arriving_covariance(state, made.evidence, LampModel::near, point);
  double squares = 0.0;
  double variance = 0.0;
  double mean = 0.0;
  for (const auto& light : made.truth.lights) mean += arriving_at(light, point).norm() / 6.0;
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector3d truth = arriving_at(made.truth.lights[k], point);
    const Eigen::Vector3d off =
        arriving_at(state.lights[k], point).normalized() - truth.normalized();
    squares += off.squaredNorm();
    const auto at = Eigen::Index(3 * k);
    const Eigen::Matrix<double, 2, 3> axes = across(truth.normalized());
    variance += (axes * covariance.block<3, 3>(at, at) * axes.transpose()).trace() * mean * mean /
                truth.squaredNorm();
  }
  // One draw of some six independent numbers: their mean square lies within a factor of three.
  EXPECT_LT(squares, 3.0 * variance);
  EXPECT_GT(squares, variance / 100.0);
}

}  // namespace
}  // namespace hada
