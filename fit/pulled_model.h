#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "fit/knit_stiffness.h"

namespace hada {

/// Where the crossings of a pulled knit were seen, as a function of what is not known of it.
///
/// Parameters: log of the ratio, continuity; logs of both lengths at rest over those of the net,
/// where they are sought; and the frame of each state where it is sought: (a, b, x, y), a crossing
/// at rest in p being seen in (1 + a, -b; b, 1 + a) p + (x, y) wales.
class PulledModel {
 public:
  static constexpr int frame_size = 4;

  PulledModel(const KnitNet& net, const std::vector<int>& repeat, KnitClamp clamp,
              const std::vector<KnitState>& states, const KnitStiffnessOptions& options);

  int residuals() const { return residuals_; }
  int springs() const { return springs_; }  // parameters of them, before those of frames
  int parameters() const { return springs_ + (framed_ ? frame_size * int(states_.size()) : 0); }

  /// Fills (model - seen) / wale of all crossings that were seen and tell something, and the
  /// derivatives from the implicit function: where F(x, p) = 0 stays so, J dx/dp = -dF/dp.
  void evaluate(const double* p, double* residuals, double* jacobian);

  /// The first state in which the knit does not come to rest, or how many there are.
  std::size_t restless(const double* p);

  /// How far clamped crossings were seen from where the stretch puts them, in wales, root mean
  /// square; 0 if none was seen.
  double clamps_off(const double* p, std::size_t state) const;

  /// The force on one edge's clamps in a state, along the pull, for nylon of k = 1: the mean of
  /// both.
  double load(const double* p, std::size_t state);

  /// J^T J at `p`.
  Eigen::MatrixXd information(const std::vector<double>& p);

 private:
  struct Frame {
    double a = 0.0, b = 0.0, x = 0.0, y = 0.0;
    Eigen::Vector2d turned(const Eigen::Vector3d& p) const {
      return {(1.0 + a) * p.x() - b * p.y(), b * p.x() + (1.0 + a) * p.y()};
    }
  };

  KnitNet net(const double* p, std::size_t state) const;
  Frame frame(const double* p, std::size_t state) const;
  bool counts(std::size_t state, std::size_t point) const;
  const Places* at_rest(const KnitNet& net, std::size_t state);
  std::vector<Places> derivatives(const KnitNet& net, const Places& places) const;
  KnitSprings with_slopes_of_tension(const KnitNet& net, KnitSprings springs, int parameter) const;

  KnitNet rest_;
  std::vector<int> repeat_;
  const std::vector<KnitState>& states_;
  int springs_;
  bool framed_;
  int residuals_ = 0;
  std::vector<std::vector<bool>> pins_;
  std::vector<Places> start_, seen_, last_;
};

}  // namespace hada
