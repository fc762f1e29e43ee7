#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/field.h"

namespace hada {

/// One noise function of a wrinkled sheet: white noise under an elliptic, oriented Gaussian kernel.
template <class T = double>
struct WrinkleComponent {
  T amplitude_mm{0.1};
  T long_mm{4.0};
  T short_mm{2.0};
  T angle_rad{0.0};

  static constexpr auto fields() {
    using F = Field<WrinkleComponent, T>;
    return std::array{
        F{"amplitude_mm", &WrinkleComponent::amplitude_mm, 1e-6, 100.0, Scale::log, "mm",
          "standard deviation of the height"},
        F{"long_mm", &WrinkleComponent::long_mm, 1e-3, 1000.0, Scale::log, "mm",
          "standard deviation of the kernel along its long axis"},
        F{"short_mm", &WrinkleComponent::short_mm, 1e-3, 1000.0, Scale::log, "mm",
          "standard deviation of the kernel across its long axis"},
        F{"angle_rad", &WrinkleComponent::angle_rad, 0.0, std::numbers::pi, Scale::half_turn, "rad",
          "direction of the long axis, counter-clockwise from +x, modulo pi"},
    };
  }
};

/// The wrinkles of a sheet of paper: a sum of independent oriented noise functions.
///
/// h(x) = sum_k a_k (G_k * w_k)(x), w_k white Gaussian noise, G_k a Gaussian ellipse of unit
/// L2 norm. Source: Kiso, Mao, Toyoura, section 3 (kernel as restored in docs/methods.md).
/// `skew`, `tail` and `sharpness` lay ridges over it (synth/ridges.h); they hardly touch the
/// spectrum.
template <class T = double>
struct Wrinkle {
  static constexpr std::string_view name = "wrinkle";
  static constexpr std::string_view summary =
      "wrinkles of paper: oriented Gaussian noise functions";

  std::vector<WrinkleComponent<T>> components = std::vector<WrinkleComponent<T>>(1);
  T floor_mm4{0.0};
  T skew{0.0};
  T tail{0.0};
  T sharpness{0.0};

  static constexpr auto parts() {
    return std::tuple{
        PartList<Wrinkle, WrinkleComponent<T>>{"components", &Wrinkle::components, 1, 8}};
  }
  static constexpr auto fields() {
    using F = Field<Wrinkle, T>;
    return std::array{
        F{"floor_mm4", &Wrinkle::floor_mm4, 0.0, 1e3, Scale::log, "mm^4",
          "power spectral density of white height noise"},
        F{"skew", &Wrinkle::skew, -1.5, 1.5, Scale::linear, "",
          "of the heights: above 0 peaks stand out, below 0 pits; 0 Gaussian", true},
        F{"tail", &Wrinkle::tail, -0.5, 0.5, Scale::linear, "",
          "of the heights: above 0 extremes are more frequent; 0 Gaussian", true},
        F{"sharpness", &Wrinkle::sharpness, -5.0, 5.0, Scale::linear, "",
          "of ridges (above 0) or furrows (below 0); 0 none", true},
    };
  }
};

/// An autocovariance of Gaussian shape: variance exp(-(xx dx^2 + 2 xy dx dy + yy dy^2)).
template <class T = double>
struct GaussianCovariance {
  T variance;
  T xx, xy, yy;  // 1/mm^2
};

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

/// The power spectral density of that autocovariance at (fx, fy) in cycles per mm, in mm^4.
template <class T>
T psd(const GaussianCovariance<T>& covariance, double fx, double fy) {
  return density_of(covariance)(fx, fy);
}

/// The power spectral density of one component at frequency (fx, fy) in cycles per mm, in mm^4.
///
/// a^2 |G^(f)|^2 = a^2 4 pi l s exp(-4 pi^2 (l^2 fl^2 + s^2 fs^2)), with (fl, fs) the frequency
/// along and across the long axis; its integral over all frequencies is a^2. A `window` (1/mm^2
/// along x and y) narrows the autocovariance by exp(-(window_x dx^2 + window_y dy^2)): what a taper
/// does to the expected periodogram near its peak. Zero gives the spectrum itself.
template <class T>
T psd(const WrinkleComponent<T>& component, double fx, double fy, double window_x = 0.0,
      double window_y = 0.0) {
  GaussianCovariance<T> covariance = autocovariance(component);
  covariance.xx += window_x;
  covariance.yy += window_y;
  return psd(covariance, fx, fy);
}

/// The power spectral density of the sheet, floor included: used by the fit and by the synthesis.
template <class T>
T psd(const Wrinkle<T>& wrinkle, double fx, double fy, double window_x = 0.0,
      double window_y = 0.0) {
  T sum = wrinkle.floor_mm4;
  for (const auto& component : wrinkle.components)
    sum += psd(component, fx, fy, window_x, window_y);
  return sum;
}

/// `psd` of a sheet as a function of (fx, fy), for many frequencies.
inline auto spectrum_of(const Wrinkle<>& wrinkle) {
  std::vector<GaussianDensity<>> densities;
  for (const auto& component : wrinkle.components)
    densities.push_back(density_of(autocovariance(component)));
  return [densities, floor = wrinkle.floor_mm4](double fx, double fy) {
    double sum = floor;
    for (const auto& density : densities) {
      constexpr double nothing = 100.0;  // e^-100 is less than rounding, and slow to compute
      if (density.exponent(fx, fy) < nothing) sum += density(fx, fy);
    }
    return sum;
  };
}

}  // namespace hada
