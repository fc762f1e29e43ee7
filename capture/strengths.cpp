#include "capture/strengths.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "capture/ambient.h"
#include "capture/lamp_colours.h"
#include "core/quantile.h"

namespace hada {
namespace {

Mask lit_in_all(const LightStack& stack) {
  Mask lit = stack.mask;
  for (const auto& samples : stack.samples) {
    for (std::size_t i = 0; i < lit.size(); ++i) lit[i] &= samples[i] == Sample::lit;
    samples.let_go();
  }
  return lit;
}

// Grey values of pixels that every light reaches, a row each, at most about 20 000 of them, over
// the strengths in force.
Eigen::MatrixXd lit_values(const LightStack& stack, const Mask& lit,
                           const std::vector<Eigen::Vector3d>& colours) {
  const std::size_t stride = std::max<std::size_t>(1, lit.size() / 20000);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < lit.size(); i += stride) {
    if (lit[i]) chosen.push_back(i);
  }
  Eigen::MatrixXd values(Eigen::Index(chosen.size()), Eigen::Index(stack.images.size()));
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    const Grid<float> grey = luminance(stack.images[k], grey_weight(colours[k]));
    for (std::size_t p = 0; p < chosen.size(); ++p) {
      values(Eigen::Index(p), Eigen::Index(k)) =
          grey[chosen[p]] / grey_of(stack.lights[k].strength);
    }
  }
  return values;
}

// Weight 1 for the three quarters of the pixels that fit best: prints, sheen and shadows do not.
Eigen::VectorXd best_fitting(const Eigen::MatrixXd& values, const Eigen::MatrixXd& predicted) {
  const Eigen::VectorXd misfit =
      (values - predicted).rowwise().norm().array() / values.rowwise().norm().array().max(1e-12);
  const std::vector<double> misfits(misfit.data(), misfit.data() + misfit.size());
  return (misfit.array() <= quantile(misfits, 0.75)).cast<double>();
}

}  // namespace

bool balance_strengths(LightStack& stack) {
  const auto lights = Eigen::Index(stack.lights.size());
  const Mask lit = lit_in_all(stack);
  std::vector<Eigen::Vector3d> colours;
  for (const Light& light : stack.lights) {
    colours.push_back(light.strength / grey_of(light.strength));
  }
  if (auto told = lamp_colours(stack.images, lit)) {
    colours = *std::move(told);
    for (std::size_t k = 0; k < colours.size(); ++k) {
      stack.lights[k].strength = grey_of(stack.lights[k].strength) * colours[k];
    }
  }
  const Eigen::MatrixXd values = lit_values(stack, lit, colours);
  if (lights < 5 || values.rows() < 100) return false;
  Eigen::MatrixX3d directions(lights, 3);
  for (Eigen::Index k = 0; k < lights; ++k) {
    directions.row(k) = stack.lights[std::size_t(k)].direction.transpose();
  }
  Eigen::VectorXd strength = Eigen::VectorXd::Ones(lights);
  constexpr int rounds = 50;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::MatrixX3d shaded = strength.asDiagonal() * directions;
    const Eigen::MatrixXd inverse = shaded.completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd scaled_normals = values * inverse.transpose();
    const Eigen::MatrixXd unit_shading = scaled_normals * directions.transpose();
    const Eigen::VectorXd weight = best_fitting(values, scaled_normals * shaded.transpose());
    const Eigen::VectorXd before = strength;
    for (Eigen::Index k = 0; k < lights; ++k) {
      const auto shading = unit_shading.col(k).array() * weight.array();
      strength[k] = (shading * values.col(k).array()).sum() /
                    std::max((shading * unit_shading.col(k).array()).sum(), 1e-300);
    }
    strength *= double(lights) / strength.sum();
    if ((strength - before).cwiseAbs().maxCoeff() < 1e-6) break;
  }
  if (!strength.allFinite() || strength.minCoeff() <= 0.0) return false;
  for (Eigen::Index k = 0; k < lights; ++k) stack.lights[std::size_t(k)].strength *= strength[k];
  return true;
}

std::vector<LightErrorMode> unknown_strengths(const std::vector<Light>& lights) {
  constexpr double usual_spread = 0.2;  // of lamps that were meant to be alike
  std::vector<LightErrorMode> modes;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    modes.emplace_back(lights.size(), Eigen::Vector3d::Zero());
    modes.back()[k] = usual_spread * lights[k].strength.mean() * lights[k].direction;
  }
  return modes;
}

}  // namespace hada
