#include "fit/growth_local.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>

namespace hada {
namespace {

constexpr double lobe_prior = 0.08;  // a typical amplitude of order 2; others by 2 / order

/// Cosine and sine of every multiple of an angle, from those of the angle itself.
class Multiples {
 public:
  Multiples(double cosine, double sine) : turn_(cosine, sine) { turns_[0] = 1.0; }

  const std::complex<double>& operator()(double order) {
    assert(order < double(turns_.size()));
    for (; known_ < std::size_t(order); ++known_) turns_[known_ + 1] = turns_[known_] * turn_;
    return turns_[std::size_t(order)];
  }

 private:
  std::array<std::complex<double>, 65> turns_;  // the highest order of the field table is 64
  std::complex<double> turn_;
  std::size_t known_ = 0;
};

/// `growth_at`, the derivatives written to any vector.
template <typename Slopes>
double set_growth(const GrowthFrame& frame, const Eigen::Vector2d& place, Slopes&& slopes) {
  const Eigen::Vector2d arm = place - frame.pith;
  const double r = std::max(arm.norm(), 1e-12);
  const Eigen::Vector2d outward = arm / r, along(-outward.y(), outward.x());
  Multiples multiples(outward.x(), outward.y());
  double factor = 1.0, by_angle = 0.0, by_radius = 0.0, share = 0.0;
  for (std::size_t l = 0; l < frame.lobes.size(); ++l) {
    const auto& lobe = frame.lobes[l];
    const bool as_before = l > 0 && lobe.from_mm == frame.lobes[l - 1].from_mm &&
                           lobe.to_mm == frame.lobes[l - 1].to_mm;
    if (!as_before) share = share_at(lobe, r);
    const auto turn = multiples(lobe.order);
    const double height = lobe.cosine * turn.real() + lobe.sine * turn.imag();
    factor += share * height;
    by_angle += share * lobe.order * (lobe.sine * turn.real() - lobe.cosine * turn.imag());
    if (share > 0.0 && share < 1.0) by_radius += height / (lobe.to_mm - lobe.from_mm);
    slopes[Eigen::Index(2 + 2 * l)] = r * share * turn.real();
    slopes[Eigen::Index(3 + 2 * l)] = r * share * turn.imag();
  }
  slopes.template head<2>() = -(factor + r * by_radius) * outward - by_angle * along;
  return r * factor;
}

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
  GrowthLocal local{0.0, Eigen::VectorXd(2 + 2 * Eigen::Index(frame.lobes.size()))};
  local.rho = set_growth(frame, place, local.slopes);
  return local;
}

double growth_at(const GrowthFrame& frame, const Eigen::Vector2d& place,
                 Eigen::MatrixXd::ColXpr slopes) {
  return set_growth(frame, place, slopes);
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
