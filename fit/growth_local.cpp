#include "fit/growth_local.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace hada {
namespace {

constexpr double lobe_prior = 0.08;  // a typical amplitude of order 2; others by 2 / order

/// Cosine and sine of every multiple of an angle, from those of the angle itself.
class Multiples {
 public:
  Multiples(double cosine, double sine) : turns_{{1.0, 0.0}}, turn_(cosine, sine) {}

  const std::complex<double>& operator()(double order) {
    while (double(turns_.size()) <= order) turns_.push_back(turns_.back() * turn_);
    return turns_[std::size_t(order)];
  }

 private:
  std::vector<std::complex<double>> turns_;
  std::complex<double> turn_;
};

}  // namespace

Eigen::VectorXd packed(const GrowthFrame& frame) {
  Eigen::VectorXd state(2 + 2 * Eigen::Index(frame.lobes.size()));
  state.head<2>() = frame.pith;
  for (std::size_t l = 0; l < frame.lobes.size(); ++l) {
    state[Eigen::Index(2 + 2 * l)] = frame.lobes[l].cosine;
    state[Eigen::Index(3 + 2 * l)] = frame.lobes[l].sine;
  }
  return state;
}

GrowthFrame unpacked(GrowthFrame frame, const Eigen::VectorXd& state) {
  frame.pith = state.head<2>();
  for (std::size_t l = 0; l < frame.lobes.size(); ++l) {
    frame.lobes[l].cosine = state[Eigen::Index(2 + 2 * l)];
    frame.lobes[l].sine = state[Eigen::Index(3 + 2 * l)];
  }
  return frame;
}

GrowthLocal growth_at(const GrowthFrame& frame, const Eigen::Vector2d& place) {
  const Eigen::Vector2d arm = place - frame.pith;
  const double r = std::max(arm.norm(), 1e-12);
  const Eigen::Vector2d outward = arm / r, along(-outward.y(), outward.x());
  Multiples multiples(outward.x(), outward.y());
  GrowthLocal local{0.0, Eigen::VectorXd(2 + 2 * Eigen::Index(frame.lobes.size()))};
  double factor = 1.0, by_angle = 0.0, by_radius = 0.0;
  for (std::size_t l = 0; l < frame.lobes.size(); ++l) {
    const auto& lobe = frame.lobes[l];
    const double share = share_at(lobe, r);
    const auto turn = multiples(lobe.order);
    const double height = lobe.cosine * turn.real() + lobe.sine * turn.imag();
    factor += share * height;
    by_angle += share * lobe.order * (lobe.sine * turn.real() - lobe.cosine * turn.imag());
    if (share > 0.0 && share < 1.0) by_radius += height / (lobe.to_mm - lobe.from_mm);
    local.slopes[Eigen::Index(2 + 2 * l)] = r * share * turn.real();
    local.slopes[Eigen::Index(3 + 2 * l)] = r * share * turn.imag();
  }
  local.rho = r * factor;
  local.slopes.head<2>() = -(factor + r * by_radius) * outward - by_angle * along;
  return local;
}

Eigen::VectorXd growth_prior(const GrowthFrame& frame) {
  Eigen::VectorXd precision = Eigen::VectorXd::Zero(packed(frame).size());
  for (std::size_t l = 0; l < frame.lobes.size(); ++l) {
    const double typical = lobe_prior * 2.0 / std::max(frame.lobes[l].order, 2.0);
    precision.segment<2>(Eigen::Index(2 + 2 * l)).setConstant(1.0 / (typical * typical));
  }
  return precision;
}

}  // namespace hada
