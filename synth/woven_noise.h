#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/field.h"
#include "core/scalar.h"
#include "synth/noise_function.h"
#include "synth/repeated_noise.h"

namespace hada {

/// A noise function that comes back two ways, as the crossings of a weave do.
///
/// Its autocovariance is that of a plain noise function, seen again at every n of one period p and
/// m of another q and fainter by exp(-n^2 / (2 repeats^2) - m^2 / (2 other_repeats^2)). The power
/// so gathers in peaks, where lines across the one period cross those of the other.
template <class T = double>
struct WovenNoise {
  T amplitude_mm{0.1};
  T long_mm{0.2};
  T short_mm{0.1};
  T angle_rad{0.0};
  T period_mm{1.0};
  T period_angle_rad{0.0};
  T repeats{2.0};
  T other_period_mm{1.0};
  T other_period_angle_rad{0.5 * std::numbers::pi};
  T other_repeats{2.0};

  static constexpr auto fields() {
    using F = Field<WovenNoise, T>;
    const auto [amplitude, longer, shorter, angle] = kernel_fields<WovenNoise, T>();
    constexpr double fewest = RepeatedNoise<>::fewest_repeats;
    constexpr double most = RepeatedNoise<>::most_repeats;
    return std::array{
        amplitude,
        longer,
        shorter,
        angle,
        F{"period_mm", &WovenNoise::period_mm, 1e-5, 1e4, Scale::log, "mm",
          "distance after which it comes back"},
        F{"period_angle_rad", &WovenNoise::period_angle_rad, 0.0, std::numbers::pi,
          Scale::half_turn, "rad", "direction in which it comes back, like angle_rad"},
        F{"repeats", &WovenNoise::repeats, fewest, most, Scale::log, "",
          "periods after which the likeness has fallen to exp(-1/2)"},
        F{"other_period_mm", &WovenNoise::other_period_mm, 1e-5, 1e4, Scale::log, "mm",
          "distance after which it comes back the other way"},
        F{"other_period_angle_rad", &WovenNoise::other_period_angle_rad, 0.0, std::numbers::pi,
          Scale::half_turn, "rad", "direction of the other way, like angle_rad"},
        F{"other_repeats", &WovenNoise::other_repeats, fewest, most, Scale::log, "",
          "the same as repeats, the other way"},
    };
  }
};

/// A distance of the plane, mm.
template <class T = double>
struct Step {
  T x, y;
};

/// An autocovariance seen again at all n p + m q, fainter by exp(-(nn n^2 + 2 nm n m + mm m^2)).
template <class T = double>
struct WovenCovariance {
  GaussianCovariance<T> kernel;
  Step<T> p, q;
  T nn, nm, mm;
};

/// What the exponent of a Gaussian says of two distances together.
template <class T>
T inner(const GaussianCovariance<T>& kernel, const Step<T>& a, const Step<T>& b) {
  return kernel.xx * a.x * b.x + kernel.xy * (a.x * b.y + a.y * b.x) + kernel.yy * a.y * b.y;
}

/// Calls visit(n, m, weight) for all n and m whose weight exp(-(nn n^2 + 2 nm n m + mm m^2) + 2 (bn
/// n + bm m) - c) is more than rounding.
template <class Visit>
void for_each_crossing(double nn, double nm, double mm, double bn, double bm, double c,
                       const Visit& visit) {
  // Completed squares: in n first, then what m alone decides.
  const double left = mm - nm * nm / nn, b = bm - nm * bn / nn, top = bn * bn / nn - c;
  const double reach = b * b + left * (top + no_likeness);
  if (reach < 0.0) return;
  const double last = std::floor((b + std::sqrt(reach)) / left);
  for (double m = std::ceil((b - std::sqrt(reach)) / left); m <= last; ++m) {
    const double along = bn - nm * m;
    const double here = along * along - nn * (mm * m * m - 2.0 * bm * m + c - no_likeness);
    if (here < 0.0) continue;
    const double end = std::floor((along + std::sqrt(here)) / nn);
    for (double n = std::ceil((along - std::sqrt(here)) / nn); n <= end; ++n) {
      visit(n, m,
            std::exp(-(nn * n * n + 2.0 * nm * n * m + mm * m * m) + 2.0 * (bn * n + bm * m) - c));
    }
  }
}

/// At a distance, mm: what is felt there of the kernel at every crossing.
inline double value_at(const WovenCovariance<>& covariance, double dx, double dy) {
  const auto& [kernel, p, q, nn, nm, mm] = covariance;
  const Step<> d{dx, dy};
  double sum = 0.0;
  for_each_crossing(nn + inner(kernel, p, p), nm + inner(kernel, p, q), mm + inner(kernel, q, q),
                    inner(kernel, d, p), inner(kernel, d, q), inner(kernel, d, d),
                    [&](double, double, double weight) { sum += weight; });
  return kernel.variance * sum;
}

/// Sum over all whole n and m of exp(-(nn n^2 + 2 nm n m + mm m^2)): Gaussians in m of combs in n.
template <class T>
T sum_over_crossings(const T& nn, const T& nm, const T& mm) {
  using std::exp;
  using std::sqrt;
  const T width = sqrt(0.5 / nn), left = mm - nm * nm / nn;
  T sum(0.0);
  for (int m = 0; value_of(left) * m * m <= no_likeness; ++m) {
    const T line = exp(-left * double(m * m)) * comb(T(nm / nn * double(m)), width);
    sum += m == 0 ? line : T(2.0 * line);
  }
  return sum * width * std::sqrt(2.0 * std::numbers::pi);
}

/// Scaled so that the variance is amplitude_mm^2, however much of the kernel lies over itself.
template <class T>
WovenCovariance<T> autocovariance(const WovenNoise<T>& noise) {
  using std::cos;
  using std::sin;
  const Step<T> p{noise.period_mm * cos(noise.period_angle_rad),
                  noise.period_mm * sin(noise.period_angle_rad)};
  const Step<T> q{noise.other_period_mm * cos(noise.other_period_angle_rad),
                  noise.other_period_mm * sin(noise.other_period_angle_rad)};
  const T nn = 0.5 / (noise.repeats * noise.repeats);
  const T mm = 0.5 / (noise.other_repeats * noise.other_repeats);
  auto kernel = autocovariance(
      WrinkleComponent<T>{noise.amplitude_mm, noise.long_mm, noise.short_mm, noise.angle_rad});
  kernel.variance /= sum_over_crossings(T(nn + inner(kernel, p, p)), T(inner(kernel, p, q)),
                                        T(mm + inner(kernel, q, q)));
  return {kernel, p, q, nn, T(0.0), mm};
}

/// The same as for what comes back one way: a lattice that the window draws in.
template <class T>
WovenCovariance<T> narrowed(const WovenCovariance<T>& covariance, const GaussianWindow& by) {
  const auto& [kernel, p, q, nn, nm, mm] = covariance;
  const GaussianCovariance<T> narrow = narrowed(kernel, by);
  const T det = narrow.xx * narrow.yy - narrow.xy * narrow.xy;
  const auto drawn_in = [&, &m = covariance.kernel](const Step<T>& step) {  // (M + W)^-1 M p
    const T x = m.xx * step.x + m.xy * step.y;
    const T y = m.xy * step.x + m.yy * step.y;
    return Step<T>{(narrow.yy * x - narrow.xy * y) / det, (narrow.xx * y - narrow.xy * x) / det};
  };
  const Step<T> a = drawn_in(p), b = drawn_in(q);
  return {narrow,
          a,
          b,
          nn + inner(kernel, p, p) - inner(narrow, a, a),
          nm + inner(kernel, p, q) - inner(narrow, a, b),
          mm + inner(kernel, q, q) - inner(narrow, b, b)};
}

/// The power spectral density of that autocovariance: the kernel's, gathered in peaks.
template <class T = double>
struct WovenDensity {
  GaussianDensity<T> kernel;
  Step<T> p, q;
  T width, other_width;  // of the lines, as a share of their distance

  T operator()(double fx, double fy) const {
    return kernel(fx, fy) * comb(T(p.x * fx + p.y * fy), width) *
           comb(T(q.x * fx + q.y * fy), other_width);
  }
};

/// Of `nm`, with which a window slants peaks whose lines do not cross at right angles, nothing is
/// seen here: a peak keeps its power and its width along and across either line.
template <class T>
WovenDensity<T> density_of(const WovenCovariance<T>& covariance) {
  using std::sqrt;
  constexpr double unit = std::numbers::sqrt2 * std::numbers::pi;
  return {density_of(covariance.kernel), covariance.p, covariance.q, sqrt(covariance.nn) / unit,
          sqrt(covariance.mm) / unit};
}

}  // namespace hada
