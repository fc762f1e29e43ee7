#include "capture/light_covariance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <Eigen/Dense>

#include "capture/joint_problem.h"

namespace hada {
namespace {

using Kind = JointProblem::Row::Kind;

// By how much the residuals of one kind count as fewer than they are.
double design_effect(const std::vector<double>& residuals,
                     const std::vector<JointProblem::Row>& rows, Kind kind) {
  std::map<int, double> sums;
  double squares = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].kind != kind) continue;
    sums[rows[i].cluster] += residuals[i];
    squares += residuals[i] * residuals[i];
  }
  double of_sums = 0.0;
  for (const auto& [cluster, sum] : sums) of_sums += sum * sum;
  return squares > 0.0 ? std::max(1.0, of_sums / squares) : 1.0;
}

// The information on the first `size` unknowns. Those of a sheet pixel come after, four each; the
// rows of a pixel stand together, so that it is marginalised as soon as they have passed.
Eigen::MatrixXd information(const ceres::CRSMatrix& jacobian, int size,
                            const std::vector<double>& row_weight) {
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(size, size);
  Eigen::Matrix4d own = Eigen::Matrix4d::Zero();
  Eigen::MatrixX4d mixed = Eigen::MatrixX4d::Zero(size, 4);
  int open = -1;  // the first column of the pixel whose rows are passing
  const auto close = [&] {
    if (open >= 0) total -= mixed * own.ldlt().solve(mixed.transpose());
    own.setZero();
    mixed.setZero();
  };
  for (int row = 0; row < jacobian.num_rows; ++row) {
    Eigen::Vector4d of_pixel = Eigen::Vector4d::Zero();
    int pixel = -1;
    const int begin = jacobian.rows[std::size_t(row)];
    const int end = jacobian.rows[std::size_t(row) + 1];
    const double weight = row_weight[std::size_t(row)];
    const auto column = [&](int i) { return jacobian.cols[std::size_t(i)]; };
    const auto value = [&](int i) { return jacobian.values[std::size_t(i)]; };
    for (int i = begin; i < end; ++i) {
      if (column(i) < size) continue;
      pixel = size + (column(i) - size) / 4 * 4;
      of_pixel[column(i) - pixel] = value(i);
    }
    if (pixel != open) close();
    open = pixel;
    for (int i = begin; i < end; ++i) {
      if (column(i) >= size) continue;
      for (int j = begin; j < end; ++j) {
        if (column(j) < size) total(column(i), column(j)) += weight * value(i) * value(j);
      }
      mixed.row(column(i)) += weight * value(i) * of_pixel.transpose();
    }
    own += weight * of_pixel * of_pixel.transpose();
  }
  close();
  return total;
}

// How what arrives at `point` changes with the unknowns of a light as Ceres moves them: two for the
// direction, one for the strength, one for the distance of a near lamp.
Eigen::MatrixXd arriving_jacobian(const LightState& light, LampModel model,
                                  const Eigen::Vector3d& point) {
  const ceres::SphereManifold<3> sphere;
  const auto moved = [&](int unknown, double by) {
    LightState next = light;
    if (unknown < 2) {
      double delta[2] = {unknown == 0 ? by : 0.0, unknown == 1 ? by : 0.0};
      sphere.Plus(light.direction.data(), delta, next.direction.data());
    } else {
      (unknown == 2 ? next.log_strength : next.inverse_distance) += by;
    }
    return arriving_at(next, point);
  };
  const int unknowns = model == LampModel::near ? 4 : 3;
  Eigen::MatrixXd jacobian(3, unknowns);
  for (int i = 0; i < unknowns; ++i) {
    // Distances are counted in the unit of the picture: a step that is small beside any lamp.
    const double step = i < 3 ? 1e-5 : 1e-5 * std::max(std::abs(light.inverse_distance), 1e-9);
    jacobian.col(i) = (moved(i, step) - moved(i, -step)) / (2.0 * step);
  }
  return jacobian;
}

// How far the shading of the matte spheres departs from the model in a way that hangs together,
// relative to a full light: what gloss, dust and light from elsewhere leave.
double unmodelled_shading(const JointState& state, const Evidence& evidence,
                          const std::vector<double>& residuals,
                          const std::vector<JointProblem::Row>& rows, double effect) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].kind != Kind::matte) continue;
    squares += residuals[i] * residuals[i];
    count += 1.0;
  }
  if (count == 0.0) return 0.0;
  double relative = 0.0;
  for (const MatteEvidence& seen : evidence.matte) {
    const SphereState& sphere = state.spheres[seen.sphere];
    relative = std::max(relative, sphere.sigma / std::exp(sphere.surface[0]));
  }
  return relative * std::sqrt(squares / count * (1.0 - 1.0 / effect));
}

}  // namespace

Eigen::MatrixXd arriving_covariance(JointState& state, const Evidence& evidence, LampModel model,
                                    const Eigen::Vector3d& point) {
  JointProblem joint(state, evidence, model);
  ceres::Problem::EvaluateOptions options;
  options.residual_blocks = joint.blocks;
  for (double* block : joint.shared) {
    if (!joint.problem.IsParameterBlockConstant(block)) options.parameter_blocks.push_back(block);
  }
  int size = 0;
  for (double* block : options.parameter_blocks) {
    size += joint.problem.ParameterBlockTangentSize(block);
  }
  options.parameter_blocks.insert(options.parameter_blocks.end(), joint.sheet.begin(),
                                  joint.sheet.end());
  options.num_threads = 1;
  std::vector<double> residuals;
  ceres::CRSMatrix jacobian;
  joint.problem.Evaluate(options, nullptr, &residuals, nullptr, &jacobian);

  const double effect = design_effect(residuals, joint.rows, Kind::matte);
  const double matte = 1.0 / effect;
  const double sheet = 1.0 / design_effect(residuals, joint.rows, Kind::sheet);
  std::vector<double> weight;
  for (const auto& row : joint.rows) {
    weight.push_back(row.kind == Kind::matte ? matte : row.kind == Kind::sheet ? sheet : 1.0);
  }
  const Eigen::MatrixXd all = information(jacobian, size, weight);
  const Eigen::MatrixXd covariance = all.ldlt().solve(Eigen::MatrixXd::Identity(size, size));

  const auto count = Eigen::Index(state.lights.size());
  const Eigen::Index unknowns = model == LampModel::near ? 4 : 3;
  Eigen::MatrixXd to_arriving = Eigen::MatrixXd::Zero(3 * count, size);
  Eigen::VectorXd arriving(3 * count);
  double mean = 0.0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const LightState& light = state.lights[std::size_t(k)];
    to_arriving.block(3 * k, unknowns * k, 3, unknowns) = arriving_jacobian(light, model, point);
    arriving.segment<3>(3 * k) = arriving_at(light, point);
    mean += arriving.segment<3>(3 * k).norm() / double(count);
  }
  // A change of all strengths alike changes nothing but the albedo.
  to_arriving -= arriving * (arriving.transpose() * to_arriving) / arriving.squaredNorm();
  Eigen::MatrixXd result = to_arriving * covariance * to_arriving.transpose() / (mean * mean);
  // A departure that grows evenly across the disc tilts a light by half of itself. How much of what
  // the fit leaves over comes with a part of that kind, which it cannot see, nobody knows: a third.
  const double tilt =
      unmodelled_shading(state, evidence, residuals, joint.rows, effect) / (2.0 * 3.0);
  result.diagonal().array() += tilt * tilt;
  return result;
}

}  // namespace hada
