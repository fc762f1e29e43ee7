#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/field.h"

namespace hada {

/// The fields of a noise function's kernel, whoever owns it.
template <class Owner, class T>
constexpr auto kernel_fields() {
  using F = Field<Owner, T>;
  return std::array{
      F{"amplitude_mm", &Owner::amplitude_mm, 1e-9, 1000.0, Scale::log, "mm",
        "standard deviation of the height"},
      F{"long_mm", &Owner::long_mm, 1e-5, 1e4, Scale::log, "mm",
        "standard deviation of the kernel along its long axis"},
      F{"short_mm", &Owner::short_mm, 1e-5, 1e4, Scale::log, "mm",
        "standard deviation of the kernel across its long axis"},
      F{"angle_rad", &Owner::angle_rad, 0.0, std::numbers::pi, Scale::half_turn, "rad",
        "direction of the long axis, counter-clockwise from +x, modulo pi"},
  };
}

/// One noise function of a wrinkled sheet: white noise under an elliptic, oriented Gaussian kernel.
template <class T = double>
struct WrinkleComponent {
  T amplitude_mm{0.1};
  T long_mm{4.0};
  T short_mm{2.0};
  T angle_rad{0.0};

  static constexpr auto fields() { return kernel_fields<WrinkleComponent, T>(); }
};

/// What multiplies an autocovariance by exp(-(xx dx^2 + 2 xy dx dy + yy dy^2)), 1/mm^2: a taper
/// does it to the expected periodogram near a peak.
struct GaussianWindow {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// An autocovariance of Gaussian shape: variance exp(-(xx dx^2 + 2 xy dx dy + yy dy^2)).
template <class T = double>
struct GaussianCovariance {
  T variance;
  T xx, xy, yy;  // 1/mm^2

  T exponent(const T& dx, const T& dy) const {
    return xx * dx * dx + 2.0 * xy * dx * dy + yy * dy * dy;
  }
};

inline constexpr double no_likeness = 45.0;  // as an exponent: e^-45 is less than rounding

/// At a distance, mm.
inline double value_at(const GaussianCovariance<>& covariance, double dx, double dy) {
  const double fall = covariance.exponent(dx, dy);
  return fall < no_likeness ? covariance.variance * std::exp(-fall) : 0.0;
}

template <class T>
GaussianCovariance<T> narrowed(const GaussianCovariance<T>& covariance, const GaussianWindow& by) {
  return {covariance.variance, covariance.xx + by.xx, covariance.xy + by.xy, covariance.yy + by.yy};
}

/// The autocovariance of one noise function: a^2 exp(-d^T P d / 4), P the inverse of the kernel's
/// covariance matrix.
template <class T>
GaussianCovariance<T> autocovariance(const WrinkleComponent<T>& component) {
  using std::cos;
  using std::sin;
  const T c = cos(component.angle_rad);
  const T s = sin(component.angle_rad);
  const T along = 0.25 / (component.long_mm * component.long_mm);
  const T across = 0.25 / (component.short_mm * component.short_mm);
  return {component.amplitude_mm * component.amplitude_mm, along * c * c + across * s * s,
          (along - across) * c * s, along * s * s + across * c * c};
}

/// The power spectral density of that autocovariance: peak exp(-(xx fx^2 + 2 xy fx fy + yy fy^2)).
template <class T = double>
struct GaussianDensity {
  T peak;        // mm^4
  T xx, xy, yy;  // mm^2

  T exponent(double fx, double fy) const {
    return xx * (fx * fx) + 2.0 * xy * (fx * fy) + yy * (fy * fy);
  }
  T operator()(double fx, double fy) const {
    using std::exp;
    return peak * exp(-exponent(fx, fy));
  }
};

template <class T>
GaussianDensity<T> density_of(const GaussianCovariance<T>& covariance) {
  using std::sqrt;
  constexpr double pi = std::numbers::pi;
  const auto& [variance, xx, xy, yy] = covariance;
  const T det = xx * yy - xy * xy;
  const T scale = pi * pi / det;
  return {variance * pi / sqrt(det), yy * scale, -xy * scale, xx * scale};
}

/// The power spectral density of one noise function at frequency (fx, fy) in cycles per mm, in
/// mm^4, seen through a window.
///
/// Of the plain one: a^2 |G^(f)|^2 = a^2 4 pi l s exp(-4 pi^2 (l^2 fl^2 + s^2 fs^2)), with (fl, fs)
/// the frequency along and across the long axis; its integral over all frequencies is a^2.
template <class Noise>
auto psd(const Noise& noise, double fx, double fy, const GaussianWindow& window = {})
    -> decltype(density_of(narrowed(autocovariance(noise), window))(fx, fy)) {
  return density_of(narrowed(autocovariance(noise), window))(fx, fy);
}

}  // namespace hada
