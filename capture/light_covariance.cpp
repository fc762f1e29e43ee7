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

// Cauchy's weight of a residual, as the fit uses it, so that outliers tell nothing; over its mean
// for a normal deviate, so that all others tell what they do.
double robust_weight(double residual) {
  const double t = residual / JointProblem::robust_width;
  constexpr double mean_weight = 0.914;
  return 1.0 / (1.0 + t * t) / mean_weight;
}

// By how much the residuals of one kind count as fewer than they are, and how much of that is more
// than the luck of so many clusters (variance 2 / count for independent residuals) can bring.
struct DesignEffect {
  double factor = 1.0;
  double excess = 0.0;
};

DesignEffect design_effect(const std::vector<double>& residuals,
                           const std::vector<JointProblem::Row>& rows, Kind kind) {
  std::map<int, double> sums;
  double squares = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].kind != kind) continue;
    const double pull = robust_weight(residuals[i]) * residuals[i];
    sums[rows[i].cluster] += pull;
    squares += pull * pull;
  }
  double of_sums = 0.0;
  for (const auto& [cluster, sum] : sums) of_sums += sum * sum;
  if (!(squares > 0.0)) return {};
  const double factor = std::max(1.0, of_sums / squares);
  return {factor, std::max(0.0, factor - 1.0 - 2.0 * std::sqrt(2.0 / double(sums.size())))};
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
                          const std::vector<JointProblem::Row>& rows, const DesignEffect& effect) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].kind != Kind::matte) continue;
    squares += robust_weight(residuals[i]) * residuals[i] * residuals[i];
    count += 1.0;
  }
  if (count == 0.0) return 0.0;
  double relative = 0.0;
  for (const MatteEvidence& seen : evidence.matte) {
    const SphereState& sphere = state.spheres[seen.sphere];
    relative = std::max(relative, sphere.sigma / std::exp(sphere.surface[0]));
  }
  return relative * std::sqrt(squares / count * effect.excess / effect.factor);
}

// The root mean square height of the sheet about its plane, as far as the lamps' nearness shows it.
double relief(const JointState& state) {
  double squares = 0.0;
  for (const auto& pixel : state.sheet) squares += pixel[3] * pixel[3];
  return state.sheet.empty() ? 0.0 : std::sqrt(squares / double(state.sheet.size()));
}

// How what arrives from every lamp changes if `point` lies higher by `lift`: where the plane of an
// uneven sheet lies is known to a part of its relief only, and all places are counted from it.
Eigen::VectorXd arriving_change(const JointState& state, const Eigen::Vector3d& point,
                                double lift) {
  Eigen::VectorXd change(3 * Eigen::Index(state.lights.size()));
  for (std::size_t k = 0; k < state.lights.size(); ++k) {
    const Eigen::Vector3d higher = point + lift * Eigen::Vector3d::UnitZ();
    change.segment<3>(3 * Eigen::Index(k)) =
        arriving_at(state.lights[k], higher) - arriving_at(state.lights[k], point);
  }
  return change;
}

// A joint problem at a state: its residuals, and their change with the free unknowns.
struct Linearised {
  JointProblem joint;
  int size = 0;  // of the unknowns but the sheet's
  std::vector<double> residuals;
  ceres::CRSMatrix jacobian;

  Linearised(JointState& state, const Evidence& evidence, LampModel model);
};

Linearised::Linearised(JointState& state, const Evidence& evidence, LampModel model)
    : joint(state, evidence, model) {
  ceres::Problem::EvaluateOptions options;
  options.residual_blocks = joint.blocks;
  for (double* block : joint.shared) {
    if (!joint.problem.IsParameterBlockConstant(block)) options.parameter_blocks.push_back(block);
  }
  for (double* block : options.parameter_blocks) {
    size += joint.problem.ParameterBlockTangentSize(block);
  }
  options.parameter_blocks.insert(options.parameter_blocks.end(), joint.sheet.begin(),
                                  joint.sheet.end());
  options.apply_loss_function = false;
  options.num_threads = 1;
  joint.problem.Evaluate(options, nullptr, &residuals, nullptr, &jacobian);
}

// Twice the cost of the residuals of one kind, as the fit counts it.
double cost_of(const Linearised& at, Kind kind) {
  constexpr double width = JointProblem::robust_width;
  double cost = 0.0;
  for (std::size_t i = 0; i < at.residuals.size(); ++i) {
    if (at.joint.rows[i].kind != kind) continue;
    const double square = at.residuals[i] * at.residuals[i];
    cost += kind == Kind::other ? square : width * width * std::log1p(square / (width * width));
  }
  return cost;
}

// What the heights of the sheet's pixels take off the cost by luck.
double luck_of_heights(const Linearised& at) {
  std::map<int, std::pair<Eigen::Matrix4d, double>> pixels;  // information, and that of the prior
  for (int row = 0; row < at.jacobian.num_rows; ++row) {
    Eigen::Vector4d change = Eigen::Vector4d::Zero();
    int pixel = -1;
    for (int i = at.jacobian.rows[std::size_t(row)]; i < at.jacobian.rows[std::size_t(row) + 1];
         ++i) {
      const int column = at.jacobian.cols[std::size_t(i)] - at.size;
      if (column < 0) continue;
      pixel = column / 4;
      change[column % 4] = at.jacobian.values[std::size_t(i)];
    }
    if (pixel < 0) continue;
    auto& [all, before] = pixels.try_emplace(pixel, Eigen::Matrix4d::Zero(), 0.0).first->second;
    all += change * change.transpose();
    if (at.joint.rows[std::size_t(row)].kind == Kind::other) before += change[3] * change[3];
  }
  double luck = 0.0;
  for (const auto& [pixel, information] : pixels) {
    const auto& [all, before] = information;
    const Eigen::Vector3d mixed = all.topRightCorner<3, 1>();
    const double known = all(3, 3) - mixed.dot(all.topLeftCorner<3, 3>().ldlt().solve(mixed));
    luck += std::log(std::max(1.0, known / before));
  }
  return luck;
}

}  // namespace

double gain_of_nearness(JointState& distant, JointState& near, const Evidence& evidence) {
  const Linearised without(distant, evidence, LampModel::distant);
  const Linearised with(near, evidence, LampModel::near);
  double gain = -luck_of_heights(with);
  for (const Kind kind : {Kind::matte, Kind::chrome, Kind::sheet, Kind::other}) {
    const bool hangs = kind == Kind::matte || kind == Kind::sheet;
    const double factor = hangs ? design_effect(with.residuals, with.joint.rows, kind).factor : 1.0;
    const double of_kind = (cost_of(without, kind) - cost_of(with, kind)) / factor;
    if (hangs && of_kind < 0.0) return of_kind;
    gain += of_kind;
  }
  return gain;
}

Eigen::MatrixXd arriving_covariance(JointState& state, const Evidence& evidence, LampModel model,
                                    const Eigen::Vector3d& point) {
  const Linearised at(state, evidence, model);
  const auto& [joint, size, residuals, jacobian] = at;
  const DesignEffect effect = design_effect(residuals, joint.rows, Kind::matte);
  const double matte = 1.0 / effect.factor;
  const double sheet = 1.0 / design_effect(residuals, joint.rows, Kind::sheet).factor;
  std::vector<double> weight;
  for (std::size_t i = 0; i < joint.rows.size(); ++i) {
    const Kind kind = joint.rows[i].kind;
    const double fewer = kind == Kind::matte ? matte : kind == Kind::sheet ? sheet : 1.0;
    weight.push_back(kind == Kind::other ? 1.0 : fewer * robust_weight(residuals[i]));
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
  if (model == LampModel::near) {
    const Eigen::VectorXd lift = arriving_change(state, point, 0.5 * relief(state)) / mean;
    result += lift * lift.transpose();
  }
  return result;
}

}  // namespace hada
