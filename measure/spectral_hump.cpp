#include "measure/spectral_hump.h"

#include <cmath>
#include <numbers>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// A wave vector as the hump sees it.
struct Place {
  double frequency, along, across;       // of the hump: its middle and its widths
  double f_along = 0.0, f_across = 0.0;  // of the wave vector, on the side of the middle
  double u, v = 0.0;                     // off the middle, in widths
};

Place place_of(const SpectralHump& hump, double fx, double fy) {
  Place place{};
  place.frequency = std::exp(hump.log_frequency);
  place.along = place.frequency * std::exp(hump.log_along);
  place.across = place.frequency * std::exp(hump.log_across);
  if (hump.ring) {
    place.u = (std::hypot(fx, fy) - place.frequency) / place.along;
    return place;
  }
  const double x = std::cos(hump.direction), y = std::sin(hump.direction);
  const double side = fx * x + fy * y < 0.0 ? -1.0 : 1.0;
  place.f_along = side * (fx * x + fy * y);
  place.f_across = side * (fy * x - fx * y);
  place.u = (place.f_along - place.frequency) / place.along;
  place.v = place.f_across / place.across;
  return place;
}

double density_at(const SpectralHump& hump, const Place& place) {
  const double area = hump.ring ? 2.0 * pi * place.frequency * std::sqrt(2.0 * pi) * place.along
                                : 4.0 * pi * place.along * place.across;
  return std::exp(hump.log_variance - 0.5 * (place.u * place.u + place.v * place.v)) / area;
}

}  // namespace

double SpectralHump::density(double fx, double fy) const {
  return density_at(*this, place_of(*this, fx, fy));
}

double SpectralHump::density(double fx, double fy, Parameters& log_derivatives) const {
  const Place at = place_of(*this, fx, fy);
  const double uu = at.u * at.u, vv = at.v * at.v;
  log_derivatives = {1.0, at.u * at.frequency / at.along + uu + vv - 2.0, uu - 1.0, 0.0, 0.0};
  if (!ring) {
    log_derivatives[3] = vv - 1.0;
    log_derivatives[4] = at.v * at.f_along / at.across - at.u * at.f_across / at.along;
  }
  return density_at(*this, at);
}

}  // namespace hada
