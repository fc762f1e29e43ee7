#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/extent.h"
#include "core/field.h"
#include "synth/noise_function.h"
#include "synth/repeated_noise.h"
#include "synth/woven_noise.h"

namespace hada {

/// The wrinkles of a sheet of paper: a sum of independent oriented noise functions.
///
/// h(x) = sum_k a_k (G_k * w_k)(x), w_k white Gaussian noise, G_k a Gaussian ellipse of unit
/// L2 norm. Source: Kiso, Mao, Toyoura, section 3 (kernel as restored in docs/methods.md).
/// `skew`, `tail` and `sharpness` lay ridges over it (synth/ridges.h); they hardly touch the
/// spectrum. `repeated` are noise functions that come back, as those of cloth do, `woven` those
/// that come back two ways.
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
  std::vector<RepeatedNoise<T>> repeated = {};
  std::vector<WovenNoise<T>> woven = {};

  static constexpr auto parts() {
    return std::tuple{
        PartList<Wrinkle, WrinkleComponent<T>>{"components", &Wrinkle::components, 1, 8},
        PartList<Wrinkle, RepeatedNoise<T>>{"repeated", &Wrinkle::repeated, 0, 8, true},
        PartList<Wrinkle, WovenNoise<T>>{"woven", &Wrinkle::woven, 0, 8, true}};
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

/// Calls visit(noise) for every noise function: plain ones, those that come back, woven ones.
template <class T, class Visit>
void for_each_noise(const Wrinkle<T>& wrinkle, const Visit& visit) {
  for (const auto& noise : wrinkle.components) visit(noise);
  for (const auto& noise : wrinkle.repeated) visit(noise);
  for (const auto& noise : wrinkle.woven) visit(noise);
}

/// Of the height, without the floor.
template <class T>
T variance_of(const Wrinkle<T>& wrinkle) {
  T sum(0.0);
  for_each_noise(wrinkle,
                 [&](const auto& noise) { sum += noise.amplitude_mm * noise.amplitude_mm; });
  return sum;
}

/// The power spectral density of the sheet, floor included: used by the fit and by the synthesis.
template <class T>
T psd(const Wrinkle<T>& wrinkle, double fx, double fy, const GaussianWindow& window = {}) {
  T sum = wrinkle.floor_mm4;
  for_each_noise(wrinkle, [&](const auto& noise) { sum += psd(noise, fx, fy, window); });
  return sum;
}

/// The window of a tile, which has waves of whole numbers only: lines thinner than a step between
/// them would be met or missed by luck. Half a step wide they keep their power to 2 %, 2
/// exp(-pi^2 / 2). Plain noise functions that are short beside the tile need none: their spectrum
/// is smooth.
inline GaussianWindow window_of_tile(const Wrinkle<>& wrinkle, const Extent& tile) {
  constexpr double short_share = 1.0 / 6.0;  // 0.7 steps wide: whole numbers see it to 1e-4
  double longest = 0.0;
  for (const auto& component : wrinkle.components)
    longest = std::max({longest, component.long_mm, component.short_mm});
  const bool smooth = longest <= short_share * std::min(tile.width(), tile.height());
  if (smooth && wrinkle.repeated.empty() && wrinkle.woven.empty()) return {};
  constexpr double half = 0.5 * std::numbers::pi * std::numbers::pi;  // 2 pi^2 (1 / 2)^2
  return {half / (tile.width() * tile.width()), 0.0, half / (tile.height() * tile.height())};
}

/// `psd` of a sheet as a function of (fx, fy), for many frequencies.
inline auto spectrum_of(const Wrinkle<>& wrinkle, const GaussianWindow& window = {}) {
  std::vector<GaussianDensity<>> densities;
  std::vector<RepeatedDensity<>> repeated;
  std::vector<WovenDensity<>> woven;
  for (const auto& component : wrinkle.components)
    densities.push_back(density_of(narrowed(autocovariance(component), window)));
  for (const auto& noise : wrinkle.repeated)
    repeated.push_back(density_of(narrowed(autocovariance(noise), window)));
  for (const auto& noise : wrinkle.woven)
    woven.push_back(density_of(narrowed(autocovariance(noise), window)));
  return [densities, repeated, woven, floor = wrinkle.floor_mm4](double fx, double fy) {
    constexpr double nothing = 100.0;  // e^-100 is less than rounding, and slow to compute
    double sum = floor;
    for (const auto& density : densities)
      if (density.exponent(fx, fy) < nothing) sum += density(fx, fy);
    for (const auto& density : repeated)
      if (density.kernel.exponent(fx, fy) < nothing) sum += density(fx, fy);
    for (const auto& density : woven)
      if (density.kernel.exponent(fx, fy) < nothing) sum += density(fx, fy);
    return sum;
  };
}

}  // namespace hada
