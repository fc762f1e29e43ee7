#include "capture/refine_lights.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Dense>

#include "capture/evidence.h"
#include "capture/joint_fit.h"
#include "capture/light_cost.h"
#include "capture/light_covariance.h"
#include "core/quantile.h"

namespace hada {
namespace {

// The typical nearness of the lamps: half the picture's diagonal over the distance.
double nearness(const JointState& state, double half) {
  std::vector<double> all;
  for (const LightState& light : state.lights) all.push_back(light.inverse_distance * half);
  return median(std::move(all));
}

// Lamps of one rig stand about equally far; a model error that is taken for nearness puts some at
// infinity. So no quarter of the lamps may be more than three times as far as the middle one.
bool stand_together(const JointState& state) {
  std::vector<double> all;
  for (const LightState& light : state.lights) all.push_back(light.inverse_distance);
  return quantile(all, 0.25) > median(all) / 3.0;
}

// Beyond a hundred times the half diagonal the direction changes by half a degree at most.
constexpr double notable_nearness = 0.01;

struct Settled {
  JointState state;
  LampModel model = LampModel::distant;
};

// Distant lamps first; then the distances are let go, and kept where they matter.
// half  half of the picture's diagonal
// said  auto, distant or near: what the owner knows
Settled settled(const Evidence& all, JointState state, double half, const std::string& said) {
  descend(state, all, LampModel::distant, 3);
  if (said == "distant") return {state, LampModel::distant};
  // One sphere by itself sees every light from one place: how far it is, only a second one or a
  // sample beside it can tell.
  if (state.spheres.size() < 2 && state.sheet.empty()) return {state, LampModel::distant};
  constexpr double first_nearness = 0.05;  // anything that is not 0: the strengths then follow
  JointState near = state;
  for (LightState& light : near.lights) light.inverse_distance = first_nearness / half;
  descend(near, all, LampModel::near, 1);
  // Under the same noise levels, distances must take off more than so many free numbers do by luck.
  const bool helps =
      said == "near" || gain_of_nearness(state, near, all) > 3.0 * double(state.lights.size());
  if (!helps || nearness(near, half) < notable_nearness) return {state, LampModel::distant};
  descend(near, all, LampModel::near, 3);
  if (said == "near") return {near, LampModel::near};
  if (nearness(near, half) < notable_nearness || !stand_together(near)) {
    return {state, LampModel::distant};
  }
  return {near, LampModel::near};
}

// How far the lights lie from where each sphere by itself sees them, in its own standard
// deviations: the median over all spheres and lights.
double strain(const JointState& state, const std::vector<SphereReading>& readings) {
  // What no reading knows of itself, radians: light that the sample throws at a matte sphere, and
  // that near lamps were read as distant ones.
  constexpr double unread_matte = 0.025;
  constexpr double unread_chrome = 0.01;
  std::vector<double> all;
  for (std::size_t s = 0; s < readings.size(); ++s) {
    const Eigen::Vector3d center = center_of(state.spheres[s].place.data(), state.table);
    const bool matte = readings[s].sphere.kind == SphereKind::matte;
    const double unread = matte ? unread_matte : unread_chrome;
    for (std::size_t k = 0; k < state.lights.size(); ++k) {
      const Light& seen = readings[s].lights[k];
      if (!std::isfinite(seen.direction_sigma)) continue;
      const Eigen::Vector3d joint = arriving_at(state.lights[k], center).normalized();
      const double sigma = std::hypot(seen.direction_sigma, unread);
      all.push_back(seen.direction.cross(joint).norm() / sigma);
    }
  }
  return median(std::move(all));
}

// Real samples leave it below 1.6. Walls behind the spheres, and cloth of a few steps of the file,
// are lit or shown as no matte sample is, and drew lights by 8 and 11 degrees: at 3.3 and more.
constexpr double most_strain = 2.5;

// Every light as each sphere alone sees it, everything else as it was found.
std::vector<std::vector<Light>> seen_alone(const JointState& state, const Evidence& all,
                                           const std::vector<SphereReading>& readings) {
  std::vector<std::vector<Light>> seen;
  for (std::size_t which = 0; which < readings.size(); ++which) {
    seen.push_back(readings[which].lights);
    for (std::size_t k = 0; k < seen[which].size(); ++k) {
      Light& light = seen[which][k];
      if (!std::isfinite(light.direction_sigma)) continue;
      light.direction = own_direction(state, all, which, k);
    }
  }
  return seen;
}

// Whether a mirror and a matte sphere contradict each other beyond what the mirror's outline and
// spots are known to.
bool contradict(const JointState& state, const Evidence& all,
                const std::vector<SphereReading>& readings) {
  std::vector<double> sigmas;
  for (const SphereReading& reading : readings) {
    if (reading.sphere.kind != SphereKind::chrome) continue;
    for (const Light& light : reading.lights) {
      if (std::isfinite(light.direction_sigma)) sigmas.push_back(light.direction_sigma);
    }
  }
  if (sigmas.empty() || all.matte.empty()) return false;
  constexpr double notable = 0.0175;  // radians: a degree
  const double most = std::max(notable, 1.5 * median(std::move(sigmas)));
  return disagreement(state, seen_alone(state, all, readings)) > most;
}

// As many as a matte sphere or the sample has pixels.
constexpr double outweighs_all = 1000.0;

// Directions of independent errors, the largest first, until hardly anything is left.
std::vector<LightErrorMode> modes_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  const double total = solver.eigenvalues().sum();
  std::vector<LightErrorMode> modes;
  double left = total;
  constexpr double negligible = 0.01;
  constexpr std::size_t most = 24;  // what many lights share is in the first few
  for (Eigen::Index i = covariance.rows() - 1;
       i >= 0 && left > negligible * total && modes.size() < most; --i) {
    const double variance = std::max(0.0, solver.eigenvalues()[i]);
    left -= variance;
    LightErrorMode mode;
    for (Eigen::Index k = 0; k < covariance.rows() / 3; ++k) {
      mode.push_back(std::sqrt(variance) * solver.eigenvectors().col(i).segment<3>(3 * k));
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

// The standard deviation of a light's direction along a tangent axis.
double direction_sigma(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& direction,
                       double length) {
  const double across = covariance.trace() - direction.dot(covariance * direction);
  return std::sqrt(std::max(0.0, 0.5 * across)) / length;
}

// Whether the strengths of all lights are still told without the sample, or by nobody.
bool may_do_without_sample(const Evidence& all, const std::vector<SphereReading>& readings,
                           std::size_t lights) {
  for (std::size_t k = 0; k < lights && !all.matte.empty(); ++k) {
    const bool told = std::any_of(readings.begin(), readings.end(), [&](const auto& reading) {
      return reading.sphere.kind == SphereKind::matte && is_seen(reading.lights[k]);
    });
    if (!told) return false;
  }
  return true;
}

}  // namespace

RefinedLights refined_lights(const Photographs& linear, const std::vector<SphereReading>& readings,
                             const std::vector<Light>& lights,
                             const std::vector<Eigen::Vector3d>& colours, double ambient) {
  const Extent& extent = linear.camera.extent;
  const double half = 0.5 * std::hypot(extent.width(), extent.height());
  const auto settled_on = [&](const Evidence& all, double mirror_weight = 1.0) {
    JointState first = first_state(all, readings, lights, linear.camera);
    first.mirror_weight = mirror_weight;
    first.sheet_ambient_sigma = 0.5 * ambient;
    return settled(all, std::move(first), half, linear.file.lamps);
  };
  Evidence all = evidence(linear, readings, colours);
  auto [state, model] = settled_on(all);
  RefinedLights refined;
  // Who says that lamps are near wants the sample asked: without it nothing tells how near.
  const bool may_leave_out = !state.sheet.empty() && linear.file.lamps != "near" &&
                             may_do_without_sample(all, readings, lights.size());
  if (may_leave_out && strain(state, readings) > most_strain) {
    refined.sample_believed = false;
    all = evidence(linear, readings, colours, false);
    Settled again = settled_on(all);
    state = std::move(again.state);
    model = again.model;
  }
  // A mirror's light hangs on its outline alone; the shading of matte things on a law that hundreds
  // of their pixels break alike.
  if (contradict(state, all, readings)) {
    Settled again = settled_on(all, outweighs_all);
    state = std::move(again.state);
    model = again.model;
  }
  const Eigen::MatrixXd covariance = arriving_covariance(state, all, model, all.sheet.center);
  refined.near = model == LampModel::near;
  refined.strengths_measured = !all.matte.empty() || !all.sheet.points.empty();
  refined.sheet_ambient = state.sheet_ambient;
  refined.lights = lights;
  double mean = 0.0;
  for (const LightState& light : state.lights) {
    mean += arriving_at(light, all.sheet.center).norm() / double(lights.size());
  }
  for (std::size_t k = 0; k < lights.size(); ++k) {
    Light& light = refined.lights[k];
    const LightState& found = state.lights[k];
    const Eigen::Vector3d arriving = arriving_at(found, all.sheet.center);
    light.direction = arriving.normalized();
    light.strength = std::exp(found.log_strength) / mean * colours[k];
    light.position.reset();
    constexpr double farthest = 1e-4;  // nearness of a lamp that might as well be at infinity
    if (refined.near && found.inverse_distance * half > farthest) {
      light.position =
          Eigen::Map<const Eigen::Vector3d>(found.direction.data()) / found.inverse_distance;
    }
    const auto at = Eigen::Index(3 * k);
    light.direction_sigma =
        direction_sigma(covariance.block<3, 3>(at, at), light.direction, arriving.norm() / mean);
  }
  refined.errors = modes_of(covariance);
  refined.seen = seen_alone(state, all, readings);
  refined.disagreement = disagreement(state, refined.seen);
  return refined;
}

}  // namespace hada
