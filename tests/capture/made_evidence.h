#pragma once

#include <cmath>
#include <vector>

#include "capture/joint_fit.h"
#include "capture/light_cost.h"
#include "core/random.h"
#include "table_scene.h"

/// Evidence made from the formulas that the joint fit believes in, with noise of a known size: only
/// such evidence can tell whether its covariance is right.
namespace hada {

struct MadeEvidence {
  Evidence evidence;
  JointState truth;
};

/// A ball of 5 mm at (-18, 0), a sheet of 12 x 12 points about (12, 0) with normals of its own.
inline MadeEvidence made_evidence(double noise, double inverse_distance, Seed seed) {
  MadeEvidence made;
  JointState& truth = made.truth;
  for (const Light& light : six_lights()) {
    LightState state;
    state.direction = {light.direction.x(), light.direction.y(), light.direction.z()};
    state.log_strength = std::log(light.strength[0]);
    state.inverse_distance = inverse_distance;
    truth.lights.push_back(state);
  }
  SphereState ball;
  ball.place = ball.prior = {-18.0, 0.0, 5.0};
  ball.prior_sigma = 0.01;
  ball.surface = {std::log(0.5), 0.4};
  ball.ambient.assign(6, 0.0);
  ball.sigma = noise;
  truth.spheres = {ball};
  truth.sheet_sigma = noise;
  std::uint64_t draw = 0;
  const auto noisy = [&](double value) { return value + noise * gaussian(seed, draw++); };

  MatteEvidence seen;
  seen.values.resize(6);
  seen.thrown.resize(6);
  const Eigen::Vector3d center = center_of(ball.place.data(), truth.table);
  for (int row = -9; row <= 9; ++row) {
    for (int col = -9; col <= 9; ++col) {
      const Eigen::Vector2d place(0.1 * col, 0.1 * row);
      if (place.norm() > 0.93) continue;
      const Ray ray{{center.x() + 5.0 * place.x(), center.y() + 5.0 * place.y(), 0.0},
                    -Eigen::Vector3d::UnitZ()};
      const auto hit = *first_hit<double>(ray, center, ball.place[2]);
      seen.rays.push_back(ray);
      seen.bends.push_back(Eigen::Vector3d::Zero());
      seen.places.push_back(place);
      for (std::size_t k = 0; k < 6; ++k) {
        seen.thrown[k].push_back(0.02 * std::max(0.0, hit.normal.x()));
        const double cosine = hit.normal.dot(arriving_at(truth.lights[k], hit.point));
        seen.values[k].push_back(noisy(0.5 * std::max(0.0, cosine) + 0.4 * seen.thrown[k].back()));
      }
    }
  }
  made.evidence.matte = {seen};

  SheetEvidence& sheet = made.evidence.sheet;
  sheet.center = {12.0, 0.0, 0.0};
  for (int row = 0; row < 12; ++row) {
    for (int col = 0; col < 12; ++col) {
      const Eigen::Vector3d point(2.0 * col + 1.0, 2.0 * row - 11.0, 0.0);
      const Eigen::Vector3d slope(0.2 * std::sin(0.6 * point.x()), 0.2 * std::cos(0.5 * point.y()),
                                  1.0);
      const Eigen::Vector3d scaled = 0.7 * slope.normalized();
      truth.sheet.push_back({scaled.x(), scaled.y(), scaled.z(), 0.0});
      sheet.points.push_back(point);
      std::vector<double> values;
      for (std::size_t k = 0; k < 6; ++k) {
        values.push_back(noisy(scaled.dot(arriving_at(truth.lights[k], point))));
      }
      sheet.values.push_back(values);
    }
  }
  return made;
}

}  // namespace hada
