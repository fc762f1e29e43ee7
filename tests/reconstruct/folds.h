#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "scenes.h"

/// Folds that all run one way, and pictures of them in which light goes to and fro between them.
namespace hada {

/// Sums of three waves across the columns, of this slope at most.
inline Relief folds(int rows, int cols, double steepest, Seed seed) {
  return relief_of(rows, cols, [=](double x, double) {
    double z = 0.0;
    double slope = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double length = 18.0 + 14.0 * k + 8.0 * uniform(seed, k, 1);
      const double share = (0.3 + 0.12 * k) / 1.26;  // 1 together
      const double phase = 2.0 * std::numbers::pi * (x / length + uniform(seed, k, 2));
      z += steepest * share * length / (2.0 * std::numbers::pi) * std::sin(phase);
      slope += steepest * share * std::cos(phase);
    }
    return Eigen::Vector3d(z, slope, 0.0);
  });
}

/// What a matte profile sends to the camera once light has gone to and fro without end, and where
/// the light itself arrives: the radiosity of its strips, each endless along the fold, of which
/// two see each other under cos a cos b / (2 d) per length. Nothing of it is shared with
/// `gather_bounce`, which follows horizons in the picture.
class Radiosity {
 public:
  Radiosity(const Relief& relief, double albedo) : albedo_(albedo) {
    for (int col = 0; col < relief.extent.cols; ++col) {
      normals_.push_back(relief.normals(0, col).cast<double>());
      places_.emplace_back(double(col), relief.height(0, col));
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count(), count());
    for (int i = 0; i < count(); ++i) {
      for (const int way : {-1, 1}) {
        for_seen(i, way, [&](int j) { system(i, j) -= albedo * form_factor(i, j); });
      }
    }
    solver_.compute(system);
  }

  int count() const { return int(places_.size()); }

  /// The light that arrives straight from a direction, cast shadows included.
  Eigen::VectorXd direct(const Eigen::Vector3d& light) const {
    Eigen::VectorXd found(count());
    for (int i = 0; i < count(); ++i) {
      found[i] = std::max(0.0, normals_[std::size_t(i)].dot(light));
      const int way = light.x() > 0.0 ? 1 : -1;
      for (int j = i + way; j >= 0 && j < count(); j += way) {
        const Eigen::Vector2d to = places_[std::size_t(j)] - places_[std::size_t(i)];
        if (to.y() * std::abs(light.x()) > light.z() * std::abs(to.x())) found[i] = 0.0;
      }
    }
    return found;
  }
  Eigen::VectorXd sent(const Eigen::VectorXd& arrives) const {
    return solver_.solve(albedo_ * arrives);
  }

 private:
  template <class Work>
  void for_seen(int i, int way, const Work& work) const {
    double horizon = -1e9;
    for (int j = i + way; j >= 0 && j < count(); j += way) {
      const Eigen::Vector2d to = places_[std::size_t(j)] - places_[std::size_t(i)];
      const double rise = to.y() / std::abs(to.x());
      if (rise >= horizon) work(j);
      horizon = std::max(horizon, rise);
    }
  }
  double form_factor(int i, int j) const {
    const Eigen::Vector2d to = places_[std::size_t(j)] - places_[std::size_t(i)];
    const auto across = [&](int k) {
      const Eigen::Vector3d& n = normals_[std::size_t(k)];
      return Eigen::Vector2d(n.x(), n.z());
    };
    const double from_i = across(i).dot(to) / to.norm();
    const double from_j = -across(j).dot(to) / to.norm();
    if (from_i <= 0.0 || from_j <= 0.0) return 0.0;
    const double length = 1.0 / normals_[std::size_t(j)].z();
    return from_i * from_j * length / (2.0 * to.norm());
  }

  double albedo_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Eigen::Vector2d> places_;  // column and height
  Eigen::PartialPivLU<Eigen::MatrixXd> solver_;
};

/// Twelve pictures of folds with light between them, noise and 12 bits.
inline LightStack pictures_with_bounce(const Relief& relief, double albedo, Seed seed) {
  LightStack stack = pictures_of(relief, ring_of_lights(12));
  const Radiosity radiosity(relief, albedo);
  for (std::size_t k = 0; k < stack.lights.size(); ++k) {
    const Eigen::VectorXd direct = radiosity.direct(stack.lights[k].direction);
    const Eigen::VectorXd sent = radiosity.sent(direct);
    for (int row = 0; row < relief.extent.rows; ++row) {
      for (int col = 0; col < relief.extent.cols; ++col) {
        const double value = sent[col] + 0.002 * gaussian(seed, row, col, std::int64_t(k));
        stack.images[k].planes[0](row, col) = float(std::round(4095.0 * value) / 4095.0);
        stack.samples[k](row, col) = direct[col] > 0.0 ? Sample::lit : Sample::shadowed;
      }
    }
  }
  return stack;
}

}  // namespace hada
