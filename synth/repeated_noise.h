#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/field.h"
#include "core/scalar.h"
#include "synth/noise_function.h"

namespace hada {

/// A noise function that comes back: threads, a weave, ribs.
///
/// Its autocovariance is that of a plain noise function, seen again at every multiple n of the
/// period p and fainter by exp(-n^2 / (2 repeats^2)). The power so gathers on lines across the
/// period, 1 / |p| apart.
template <class T = double>
struct RepeatedNoise {
  T amplitude_mm{0.1};
  T long_mm{0.4};
  T short_mm{0.2};
  T angle_rad{0.0};
  T period_mm{1.0};
  T period_angle_rad{0.0};
  T repeats{2.0};

  static constexpr auto fields() {
    using F = Field<RepeatedNoise, T>;
    const auto [amplitude, longer, shorter, angle] = kernel_fields<RepeatedNoise, T>();
    return std::array{
        amplitude,
        longer,
        shorter,
        angle,
        F{"period_mm", &RepeatedNoise::period_mm, 1e-5, 1e4, Scale::log, "mm",
          "distance after which it comes back"},
        F{"period_angle_rad", &RepeatedNoise::period_angle_rad, 0.0, std::numbers::pi,
          Scale::half_turn, "rad", "direction in which it comes back, like angle_rad"},
        F{"repeats", &RepeatedNoise::repeats, fewest_repeats, most_repeats, Scale::log, "",
          "periods after which the likeness has fallen to exp(-1/2)"},
    };
  }

  /// Below it little is seen of a period: its lines rise 9 % above the mean, 2 exp(-1 / (2 0.4^2)).
  static constexpr double fewest_repeats = 0.4;
  static constexpr double most_repeats = 30.0;
};

/// The noise function that comes back.
template <class T>
WrinkleComponent<T> kernel_of(const RepeatedNoise<T>& noise) {
  return {noise.amplitude_mm, noise.long_mm, noise.short_mm, noise.angle_rad};
}

/// Sum over all whole n of exp(-c n^2), c > 0. By Jacobi's identity the series falls at least as
/// fast as exp(-pi n^2); three terms of a side leave 1e-21.
template <class T>
T sum_of_gaussians(const T& c) {
  using std::exp;
  using std::sqrt;
  constexpr double pi = std::numbers::pi;
  const bool few = value_of(c) > pi;
  const T fall = few ? T(c) : T(pi * pi / c);
  T sum(1.0);
  for (int n = 1; n <= 3; ++n) sum += 2.0 * exp(-fall * double(n * n));
  return few ? sum : T(sum * sqrt(pi / c));
}

/// An autocovariance seen again at all multiples n of (x, y), fainter by exp(-fall n^2).
template <class T = double>
struct RepeatedCovariance {
  GaussianCovariance<T> kernel;
  T x, y;  // mm
  T fall;
};

/// At a distance, mm: what is felt there of the kernel at every multiple.
inline double value_at(const RepeatedCovariance<>& covariance, double dx, double dy) {
  const auto& [kernel, x, y, fall] = covariance;
  // The exponent is quadratic in n: a n^2 - 2 b n + c.
  const double a = fall + kernel.exponent(x, y);
  const double b = kernel.xx * dx * x + kernel.xy * (dx * y + dy * x) + kernel.yy * dy * y;
  const double reach = b * b - a * (kernel.exponent(dx, dy) - no_likeness);
  if (reach < 0.0) return 0.0;
  double sum = 0.0;
  const double last = std::floor((b + std::sqrt(reach)) / a);
  for (double n = std::ceil((b - std::sqrt(reach)) / a); n <= last; ++n)
    sum += std::exp(-fall * n * n) * value_at(kernel, dx - n * x, dy - n * y);
  return sum;
}

/// Scaled so that the variance is amplitude_mm^2, however much of the kernel lies over itself.
template <class T>
RepeatedCovariance<T> autocovariance(const RepeatedNoise<T>& noise) {
  using std::cos;
  using std::sin;
  const T x = noise.period_mm * cos(noise.period_angle_rad);
  const T y = noise.period_mm * sin(noise.period_angle_rad);
  const T fall = 0.5 / (noise.repeats * noise.repeats);
  auto kernel = autocovariance(
      WrinkleComponent<T>{noise.amplitude_mm, noise.long_mm, noise.short_mm, noise.angle_rad});
  kernel.variance /= sum_of_gaussians(T(fall + kernel.exponent(x, y)));
  return {kernel, x, y, fall};
}

/// The product of Gaussians at all multiples and one at 0 is again one of Gaussians at multiples,
/// of a distance that the window draws in.
template <class T>
RepeatedCovariance<T> narrowed(const RepeatedCovariance<T>& covariance, const GaussianWindow& by) {
  const auto& [kernel, x, y, fall] = covariance;
  const GaussianCovariance<T> narrow = narrowed(kernel, by);
  // (M + W)^-1 M p, with M of the kernel and W of the window.
  const T across = kernel.xx * x + kernel.xy * y, up = kernel.xy * x + kernel.yy * y;
  const T det = narrow.xx * narrow.yy - narrow.xy * narrow.xy;
  const T drawn_x = (narrow.yy * across - narrow.xy * up) / det;
  const T drawn_y = (narrow.xx * up - narrow.xy * across) / det;
  return {narrow, drawn_x, drawn_y,
          fall + kernel.exponent(x, y) - narrow.exponent(drawn_x, drawn_y)};
}

/// Gaussians of standard deviation `width` at all whole numbers; 1 in the mean.
template <class T>
T comb(const T& phase, const T& width) {
  using std::cos;
  using std::exp;
  constexpr double pi = std::numbers::pi;
  // Lines that flow together are a cosine, to 5e-9; of others seven are felt.
  if (value_of(width) > 0.5)
    return 1.0 + 2.0 * exp(-2.0 * pi * pi * width * width) * cos(2.0 * pi * phase);
  // Plain numbers and their first derivatives, which is all that a dual number wants of them.
  const double w = value_of(width), nearest = std::round(value_of(phase));
  double sum = 0.0, by_phase = 0.0, by_width = 0.0;
  const int last = std::min(int(9.0 * w + 0.5), 3);  // e^-40 is less than rounding
  for (int n = -last; n <= last; ++n) {
    const double at = (value_of(phase) - nearest - n) / w;
    const double one = std::exp(-0.5 * at * at);
    sum += one;
    by_phase -= at / w * one;
    by_width += at * at / w * one;
  }
  const T whole = sum + by_phase * (phase - value_of(phase)) + by_width * (width - w);
  return whole / (width * std::sqrt(2.0 * pi));
}

/// The power spectral density of that autocovariance: the kernel's, gathered on lines.
template <class T = double>
struct RepeatedDensity {
  GaussianDensity<T> kernel;
  T x, y;   // of the period, mm
  T width;  // of the lines, as a share of their distance

  T operator()(double fx, double fy) const {
    return kernel(fx, fy) * comb(T(x * fx + y * fy), width);
  }
};

template <class T>
RepeatedDensity<T> density_of(const RepeatedCovariance<T>& covariance) {
  using std::sqrt;
  const auto& [kernel, x, y, fall] = covariance;
  return {density_of(kernel), x, y, sqrt(fall) / (std::numbers::sqrt2 * std::numbers::pi)};
}

}  // namespace hada
