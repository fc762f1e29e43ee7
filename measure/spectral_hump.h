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

  /// unit^2 per (cycle / unit)^2
  double density(double fx, double fy) const;
  /// The same, and its derivatives by the five parameters in their order over it.
  double density(double fx, double fy, Parameters& log_derivatives) const;

  Parameters parameters() const {
    return {log_variance, log_frequency, log_along, log_across, direction};
  }
  SpectralHump with(const Parameters& changed) const {
    return {changed[0], changed[1], changed[2], changed[3], changed[4], ring};
  }
  /// Of the five those that are its own.
  int degrees_of_freedom() const { return ring ? 3 : parameter_count; }
};

}  // namespace hada
