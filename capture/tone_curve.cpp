#include "capture/tone_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "capture/matte_sphere.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr std::array exponents{0.40, 0.45, 0.50, 0.56, 0.63, 0.71, 0.79, 0.89, 1.0,
                               1.12, 1.26, 1.41, 1.59, 1.78, 2.0,  2.24, 2.52};
constexpr std::size_t unit_exponent = 8;

// The misfit of a matte sphere in one picture under every exponent.
std::array<double, exponents.size()> misfits_by_exponent(const Photographs& linear, std::size_t k,
                                                         const Sphere& sphere) {
  const Grid<float> grey = luminance(linear.images[k]);
  Grid<float> bent = grey;
  const int reach = int(std::ceil(sphere.radius_px)) + 1;
  std::array<double, exponents.size()> misfits{};
  for (std::size_t e = 0; e < exponents.size(); ++e) {
    for (int row = int(sphere.center_px.y()) - reach; row <= sphere.center_px.y() + reach; ++row) {
      for (int col = int(sphere.center_px.x()) - reach; col <= sphere.center_px.x() + reach;
           ++col) {
        if (!grey.contains(row, col)) continue;
        bent(row, col) = std::pow(std::max(0.0f, grey(row, col)), float(exponents[e]));
      }
    }
    misfits[e] = matte_shading(bent, linear.saturated[k], linear.camera, sphere).misfit;
  }
  return misfits;
}

// The lowest point of the parabola through three neighbours, in logarithms of the exponents.
double best_exponent(const std::vector<double>& misfits, std::size_t best) {
  if (best == 0 || best + 1 == misfits.size()) return exponents[best];
  const double left = misfits[best - 1] - misfits[best];
  const double right = misfits[best + 1] - misfits[best];
  const double step = std::log(exponents[best + 1] / exponents[best]);
  const double shift = left + right > 0.0 ? 0.5 * (left - right) / (left + right) : 0.0;
  return exponents[best] * std::exp(shift * step);
}

}  // namespace

std::vector<std::string> remarks_on_curve(const Photographs& linear,
                                          const Calibration& calibration) {
  constexpr std::size_t most_pictures = 8;  // a curve is the same in all
  const std::size_t count = linear.images.size();
  std::vector<double> misfits(exponents.size());
  double pictures = 0.0;
  for (const SphereReading& reading : calibration.readings) {
    if (reading.sphere.kind != SphereKind::matte) continue;
    std::vector<std::size_t> lit;  // a disc in shadow says nothing of the curve
    for (std::size_t k = 0; k < count; ++k) {
      if (std::isfinite(reading.lights[k].direction_sigma)) lit.push_back(k);
    }
    const std::size_t asked = std::min(most_pictures, lit.size());
    std::vector<std::array<double, exponents.size()>> seen(asked);
    for_each_index(int(asked), [&](int i) {
      const std::size_t k = lit[std::size_t(i) * lit.size() / asked];
      seen[std::size_t(i)] = misfits_by_exponent(linear, k, reading.sphere);
    });
    for (const auto& picture : seen) {
      for (std::size_t e = 0; e < exponents.size(); ++e) misfits[e] += picture[e];
    }
    pictures += double(asked);
  }
  if (pictures == 0.0) return {};
  const auto best = std::size_t(std::min_element(misfits.begin(), misfits.end()) - misfits.begin());
  const double exponent = best_exponent(misfits, best);
  constexpr double notable = 1.2;
  constexpr double better = 0.67;
  if (std::abs(std::log(exponent)) < std::log(notable) ||
      misfits[best] > better * misfits[unit_exponent]) {
    return {};
  }
  const std::string numbers = fmt::format(
      "the shading of the matte sphere is off by {:.1f} % as they are, by {:.1f} % without it",
      100.0 * misfits[unit_exponent] / pictures, 100.0 * misfits[best] / pictures);
  if (calibration.linear) {
    return {fmt::format(
        "These pictures are not linear (gamma about {:.1f}): {}; develop them without a tone "
        "curve, or say \"encoding\": \"srgb\" in capture.json if that is what it is.",
        exponent, numbers)};
  }
  return {fmt::format(
      "Taken as sRGB these pictures are not linear (an exponent of about {:.1f} is left): {}; "
      "check \"encoding\" in capture.json, and develop without a tone curve.",
      exponent, numbers)};
}

}  // namespace hada
