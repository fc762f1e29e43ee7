#pragma once

#include <array>

namespace hada {

/// A hump of the power spectrum of a plane: waves of about one length, and of one direction or, as
/// a ring, of all. Its wave vectors are Gaussian about +-f, along f and across it by a width each;
/// of a ring the frequencies alone are.
///
/// Source: as the spectrum of Gabor noise, Lagae et al., ACM Transactions on Graphics 28(3), 2009,
/// section 3, here with two widths.
struct SpectralHump {
  static constexpr int parameter_count = 5;
  using Parameters = std::array<double, parameter_count>;

  double log_variance = 0.0;   // unit^2
  double log_frequency = 0.0;  // cycles per unit
  double log_along = 0.0;      // width along the wave vector over the frequency
  double log_across = 0.0;     // and across; of no meaning in a ring
  double direction = 0.0;      // of the wave vector, counter-clockwise from +x, radians; likewise
  bool ring = false;

  Parameters parameters() const {
    return {log_variance, log_frequency, log_along, log_across, direction};
  }
  SpectralHump with(const Parameters& changed) const {
    return {changed[0], changed[1], changed[2], changed[3], changed[4], ring};
  }
  /// Of the five those that are its own.
  int degrees_of_freedom() const { return ring ? 3 : parameter_count; }
};

/// A hump that is asked at many places: what they have in common is worked out once.
class HumpDensity {
 public:
  explicit HumpDensity(const SpectralHump& hump);

  /// unit^2 per (cycle / unit)^2
  double operator()(double fx, double fy) const;
  /// The same, and the derivatives of its logarithm by the five parameters in their order.
  double operator()(double fx, double fy, SpectralHump::Parameters& log_derivatives) const;

  /// How far from 0 along an axis, 0 for x and 1 for y, the hump reaches up to so many widths.
  double reach(int axis, double widths) const;

 private:
  struct Place;
  Place place(double fx, double fy) const;
  double at(const Place& place) const;

  bool ring_;
  double x_, y_;                       // the direction
  double frequency_, along_, across_;  // the middle and the widths
  double top_;
};

}  // namespace hada
