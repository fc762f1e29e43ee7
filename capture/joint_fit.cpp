#include "capture/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include <Eigen/Dense>
#include <ceres/ceres.h>
#include <glog/logging.h>

#include "capture/joint_problem.h"
#include "capture/light_cost.h"
#include "capture/sphere_geometry.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double least_sphere_sigma_px = 0.01;

double spread_of(std::vector<double> residuals) {
  for (double& residual : residuals) residual = std::abs(residual);
  return residuals.empty() ? 0.0 : 1.4826 * median(std::move(residuals));
}

// Residuals of a matte sphere in one picture, in its units; NaN where the value is.
std::vector<double> matte_residuals(const JointState& state, const MatteEvidence& seen,
                                    std::size_t k) {
  const SphereState& sphere = state.spheres[seen.sphere];
  const LightState& light = state.lights[k];
  const double one = 1.0;
  std::vector<double> residuals;
  for (std::size_t i = 0; i < seen.rays.size(); ++i) {
    const MatteCost cost{seen.rays[i],      seen.bends[i],      seen.values[k][i],
                         seen.thrown[k][i], &sphere.ambient[k], &one};
    double residual = 0.0;
    cost(light.direction.data(), &light.log_strength, &light.inverse_distance, &state.table,
         sphere.place.data(), sphere.surface.data(), &residual);
    residuals.push_back(residual);
  }
  return residuals;
}

// The ambient light of a picture is what the side of the sphere shows that its light does not
// reach. Left free, it would be bent by whatever is not Lambertian on the lit side.
void update_ambient(JointState& state, const MatteEvidence& seen) {
  SphereState& sphere = state.spheres[seen.sphere];
  const Eigen::Vector3d center = center_of(sphere.place.data(), state.table);
  for (std::size_t k = 0; k < state.lights.size(); ++k) {
    const Eigen::Vector3d light = arriving_at(state.lights[k], center).normalized();
    std::vector<double> dark;
    for (std::size_t i = 0; i < seen.rays.size(); ++i) {
      const auto hit = first_hit<double>(seen.rays[i], center, sphere.place[2]);
      constexpr double turned_away = -0.1;
      if (!hit || hit->normal.dot(light) > turned_away || std::isnan(seen.values[k][i])) continue;
      dark.push_back(seen.values[k][i] - sphere.surface[1] * seen.thrown[k][i]);
    }
    constexpr std::size_t enough = 15;
    sphere.ambient[k] = dark.size() < enough ? 0.0 : std::max(0.0, median(std::move(dark)));
  }
}

// Half of the two components of a highlight's residual go into its own light's direction; a few
// highlights say little of their own noise, so it is drawn to what one alone was thought to have.
void update_chrome_sigma(JointState& state, const Evidence& evidence, std::size_t which) {
  double squares = 0.0;
  double count = 0.0;
  double expected = 0.0;
  const double one = 1.0;
  for (const ChromeEvidence& seen : evidence.chrome) {
    if (seen.sphere != which) continue;
    const LightState& light = state.lights[seen.light];
    const ChromeCost cost{seen.ray, seen.offset, across(vector_of(light.direction.data())), &one};
    double residuals[2];
    cost(light.direction.data(), &light.inverse_distance, &state.table,
         state.spheres[which].place.data(), residuals);
    squares += residuals[0] * residuals[0] + residuals[1] * residuals[1];
    expected += 2.0 * seen.sigma * seen.sigma;
    count += 2.0;
  }
  if (count == 0.0) return;
  constexpr double shared_freedom = 8.0;  // a linear map of all lights
  constexpr double prior_freedom = 4.0;
  const double typical = expected / count;
  const bool spheres_alone = state.sheet.empty();
  const double freedom = spheres_alone ? 0.0 : std::max(0.0, count - shared_freedom);
  state.spheres[which].sigma = std::sqrt(
      ((spheres_alone ? 0.0 : squares) + prior_freedom * typical) / (freedom + prior_freedom));
}

// Lamps of one rig are often alike. How alike, they say themselves.
void update_strength_sigma(JointState& state) {
  double mean = 0.0;
  const double count = double(state.lights.size());
  for (const LightState& light : state.lights) mean += light.log_strength / count;
  double squares = 0.0;
  for (const LightState& light : state.lights) {
    squares += (light.log_strength - mean) * (light.log_strength - mean);
  }
  state.strength_sigma = std::clamp(std::sqrt(squares / (count - 1.0)), 0.002, 0.5);
}

void update_sigmas(JointState& state, const Evidence& evidence) {
  for (std::size_t which = 0; which < state.spheres.size(); ++which) {
    update_chrome_sigma(state, evidence, which);
  }
  if (state.lights.size() > 3) update_strength_sigma(state);
  for (const MatteEvidence& seen : evidence.matte) {
    std::vector<double> all;
    for (std::size_t k = 0; k < state.lights.size(); ++k) {
      const auto residuals = matte_residuals(state, seen, k);
      std::copy_if(residuals.begin(), residuals.end(), std::back_inserter(all),
                   [](double residual) { return !std::isnan(residual); });
    }
    SphereState& sphere = state.spheres[seen.sphere];
    sphere.sigma = std::max(spread_of(std::move(all)), 1e-4 * std::exp(sphere.surface[0]));
  }
  if (evidence.sheet.points.empty()) return;
  std::vector<double> all;
  std::vector<double> values;
  for (std::size_t p = 0; p < evidence.sheet.points.size(); ++p) {
    for (std::size_t k = 0; k < state.lights.size(); ++k) {
      const double value = evidence.sheet.values[p][k];
      if (std::isnan(value)) continue;
      values.push_back(value);
      Eigen::Vector3d point = evidence.sheet.points[p];
      point.z() = state.sheet[p][3];
      all.push_back(value - state.sheet_ambient -
                    vector_of(state.sheet[p].data()).dot(arriving_at(state.lights[k], point)));
    }
  }
  if (values.empty()) return;
  // Albedo and normal of each pixel have taken three of its residuals.
  const double count = double(values.size()) / double(evidence.sheet.points.size());
  const double freedom = std::sqrt(count / std::max(count - 3.0, 1.0));
  state.sheet_sigma =
      std::max(freedom * spread_of(std::move(all)), 1e-4 * median(std::move(values)));
}

// The sheet under the lights in force, pixel by pixel.
void solve_sheet(JointState& state, const SheetEvidence& sheet) {
  state.sheet.assign(sheet.points.size(), {0.0, 0.0, 0.0, 0.0});
  for (std::size_t p = 0; p < sheet.points.size(); ++p) {
    Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < state.lights.size(); ++k) {
      if (std::isnan(sheet.values[p][k])) continue;
      const Eigen::Vector3d light = arriving_at(state.lights[k], sheet.points[p]);
      normal += light * light.transpose();
      right += sheet.values[p][k] * light;
    }
    Eigen::Map<Eigen::Vector3d>(state.sheet[p].data()) = normal.ldlt().solve(right);
  }
}

void descend_once(JointState& state, const Evidence& evidence, LampModel model) {
  JointProblem joint(state, evidence, model);
  ceres::Solver::Options how;
  how.linear_solver_type = joint.sheet.empty() ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::DENSE_SCHUR;
  // The sheet's pixels are eliminated first. Left to itself Ceres orders what is in one group by
  // its place in memory, and the last digits with it; a group for each unknown settles that.
  auto order = std::make_shared<ceres::ParameterBlockOrdering>();
  for (double* block : joint.sheet) order->AddElementToGroup(block, 0);
  int group = 1;
  for (double* block : joint.shared) order->AddElementToGroup(block, group++);
  how.linear_solver_ordering = order;
  how.max_num_iterations = 20;
  how.function_tolerance = 1e-6;
  how.num_threads = 1;  // two do not add up in the same order
  how.logging_type = ceres::SILENT;
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres speaks of every step that it has to refuse
  ceres::Solver::Summary summary;
  ceres::Solve(how, &joint.problem, &summary);
  state.cost = summary.final_cost;
}

}  // namespace

Eigen::Vector3d arriving_at(const LightState& light, const Eigen::Vector3d& point) {
  const Eigen::Vector3d direction = vector_of(light.direction.data());
  return std::exp(light.log_strength) * arriving<double>(direction, light.inverse_distance, point);
}

JointState first_state(const Evidence& evidence, const std::vector<SphereReading>& readings,
                       const std::vector<Light>& lights, const Camera& camera) {
  JointState state;
  if (camera.model == Camera::Model::perspective) state.eye = camera.distance();
  double mean = 0.0;
  for (const Light& light : lights) mean += light.strength[0] / double(lights.size());
  for (const Light& light : lights) {
    LightState next;
    Eigen::Map<Eigen::Vector3d>(next.direction.data()) = light.direction;
    next.log_strength = std::log(light.strength[0] / mean);
    state.lights.push_back(next);
  }
  for (const SphereReading& reading : readings) {
    const SphereInSpace in_place = in_space(reading.sphere, camera);
    SphereState sphere;
    sphere.place = {in_place.center.x(), in_place.center.y(), in_place.radius};
    sphere.prior = sphere.place;
    sphere.prior_sigma =
        std::max(reading.sphere.sigma_px, least_sphere_sigma_px) * camera.extent.pitch;
    sphere.ambient.assign(lights.size(), 0.0);
    state.spheres.push_back(sphere);
  }
  for (const ChromeEvidence& seen : evidence.chrome) {
    state.spheres[seen.sphere].sigma = seen.sigma;
  }
  for (const MatteEvidence& seen : evidence.matte) {
    SphereState& sphere = state.spheres[seen.sphere];
    std::vector<double> values;
    for (std::size_t k = 0; k < lights.size(); ++k) {
      for (const double value : seen.values[k]) {
        if (!std::isnan(value)) values.push_back(value * mean / lights[k].strength[0]);
      }
    }
    // Most of a sphere that lights meet from all sides is lit nearly squarely by some of them.
    const double full = std::max(quantile(std::move(values), 0.95), 1e-9);
    sphere.surface = {std::log(full), 0.5};
    sphere.sigma = 0.02 * full;
    update_ambient(state, seen);
  }
  solve_sheet(state, evidence.sheet);
  std::vector<double> values;
  for (const auto& pixel : evidence.sheet.values) {
    for (const double value : pixel) {
      if (!std::isnan(value)) values.push_back(value);
    }
  }
  if (!values.empty()) state.sheet_sigma = 0.02 * median(std::move(values));
  return state;
}

void descend(JointState& state, const Evidence& evidence, LampModel model, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    descend_once(state, evidence, model);
    for (const MatteEvidence& seen : evidence.matte) update_ambient(state, seen);
    if (round + 1 < rounds) update_sigmas(state, evidence);
  }
}

Eigen::Vector3d own_direction(const JointState& state, const Evidence& evidence, std::size_t sphere,
                              std::size_t light) {
  const SphereState& found = state.spheres[sphere];
  const Eigen::Vector3d center = center_of(found.place.data(), state.table);
  Eigen::Vector3d direction = arriving_at(state.lights[light], center).normalized();
  for (const ChromeEvidence& seen : evidence.chrome) {
    if (seen.sphere != sphere || seen.light != light) continue;
    const auto middle = mirrored<double>(seen.ray, center, found.place[2]);
    if (middle) direction = (middle->direction + seen.offset).normalized();
  }
  for (const MatteEvidence& seen : evidence.matte) {
    if (seen.sphere != sphere) continue;
    // What the joint fit leaves over on the lit side, read as a change of the light.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const auto residuals = matte_residuals(state, seen, light);
    for (std::size_t i = 0; i < seen.rays.size(); ++i) {
      const auto hit = first_hit<double>(seen.rays[i], center, found.place[2]);
      if (!hit || std::isnan(residuals[i]) || hit->normal.dot(direction) <= 0.0) continue;
      normal += hit->normal * hit->normal.transpose();
      right += residuals[i] * hit->normal;
    }
    normal.diagonal().array() += 1e-12 * normal.trace() + 1e-300;
    const double full =
        std::exp(found.surface[0]) * arriving_at(state.lights[light], center).norm();
    direction = (direction + normal.ldlt().solve(right) / full).normalized();
  }
  return direction;
}

double disagreement(const JointState& state, const std::vector<std::vector<Light>>& seen) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < state.lights.size(); ++k) {
    std::vector<Eigen::Vector3d> off;  // of each sphere that sees the light, from the joint fit
    for (std::size_t s = 0; s < seen.size(); ++s) {
      if (!std::isfinite(seen[s][k].direction_sigma)) continue;
      const Eigen::Vector3d center = center_of(state.spheres[s].place.data(), state.table);
      off.push_back(seen[s][k].direction - arriving_at(state.lights[k], center).normalized());
    }
    for (std::size_t a = 0; a < off.size(); ++a) {
      for (std::size_t b = a + 1; b < off.size(); ++b) {
        sum += (off[a] - off[b]).norm();
        ++count;
      }
    }
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace hada
