#include "measure/spectral_hump.h"

#include <cmath>
#include <numbers>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

/// A wave vector as the hump sees it.
struct HumpDensity::Place {
  double f_along = 0.0, f_across = 0.0;  // on the side of the hump's middle
  double u, v = 0.0;                     // off the middle, in widths
};

HumpDensity::HumpDensity(const SpectralHump& hump)
    : ring_(hump.ring),
      x_(std::cos(hump.direction)),
      y_(std::sin(hump.direction)),
      frequency_(std::exp(hump.log_frequency)),
      along_(frequency_ * std::exp(hump.log_along)),
      across_(frequency_ * std::exp(hump.log_across)) {
  const double area =
      ring_ ? 2.0 * pi * frequency_ * std::sqrt(2.0 * pi) * along_ : 4.0 * pi * along_ * across_;
  top_ = std::exp(hump.log_variance) / area;
}

HumpDensity::Place HumpDensity::place(double fx, double fy) const {
  if (ring_) return {.u = (std::sqrt(fx * fx + fy * fy) - frequency_) / along_};
  const double along = fx * x_ + fy * y_, across = fy * x_ - fx * y_;
  const double side = along < 0.0 ? -1.0 : 1.0;
  return {side * along, side * across, (side * along - frequency_) / along_,
          side * across / across_};
}

double HumpDensity::at(const Place& place) const {
  return top_ * std::exp(-0.5 * (place.u * place.u + place.v * place.v));
}

double HumpDensity::operator()(double fx, double fy) const {
  return at(place(fx, fy));
}

double HumpDensity::operator()(double fx, double fy,
                               SpectralHump::Parameters& log_derivatives) const {
  const Place there = place(fx, fy);
  const double uu = there.u * there.u, vv = there.v * there.v;
  log_derivatives = {1.0, there.u * frequency_ / along_ + uu + vv - 2.0, uu - 1.0, 0.0, 0.0};
  if (!ring_) {
    log_derivatives[3] = vv - 1.0;
    log_derivatives[4] = there.v * there.f_along / across_ - there.u * there.f_across / along_;
  }
  return at(there);
}

double HumpDensity::reach(int axis, double widths) const {
  const double far = frequency_ + widths * along_;
  if (ring_) return far;
  const double along = std::abs(axis == 0 ? x_ : y_), across = std::abs(axis == 0 ? y_ : x_);
  return far * along + widths * across_ * across;
}

}  // namespace hada
