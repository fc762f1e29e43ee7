#pragma once

#include <cmath>
#include <vector>

#include "measure/spectral_hump.h"
#include "measure/spectrum.h"

namespace hada {

/// Neighbouring ordinates of a spectrum, seen as one.
struct SpectralPatch {
  double fx = 0.0, fy = 0.0;  // mean frequency, cycles per unit
  double power = 0.0;         // mean, unit^4
  double count = 0.0;         // ordinates; f and -f count once
};

struct SpectralPatches {
  std::vector<SpectralPatch> all;
  Extent extent;              // of the map
  double independence = 1.0;  // the part of the ordinates that are independent witnesses
};

/// The half plane of a spectrum in patches of 4 % of the frequency and 4 degrees; near 0 an
/// ordinate each. Left out are the waves that hardly fit into the map once, and those near the
/// Nyquist frequency.
SpectralPatches patches_of(const Spectrum& spectrum);

/// What is no hump of a spectrum: white noise and a power of the frequency, unit^4.
struct SpectralGround {
  double floor, log_fall, steepness;

  double fall(double log_f) const { return std::exp(log_fall - steepness * log_f); }
  double operator()(double log_f) const { return floor + fall(log_f); }
};

/// A spectrum as a sum: humps, over white noise and a power of the frequency.
struct HumpMixture {
  std::vector<SpectralHump> humps;
  double log_floor = 0.0;  // of the white noise, unit^4
  double log_fall = 0.0;   // of the power law at 1 cycle per unit, unit^4
  double steepness = 2.0;  // of the power law: it goes with frequency to the minus this

  SpectralGround ground() const { return {std::exp(log_floor), log_fall, steepness}; }
};

/// The density of a mixture that is asked at many places, unit^4; not at frequency 0.
class MixtureDensity {
 public:
  explicit MixtureDensity(const HumpMixture& mixture);
  double operator()(double fx, double fy) const;

 private:
  SpectralGround ground_;
  std::vector<HumpDensity> humps_;
};

/// How much of a hump's waves is where nothing else is as strong: the mean over its power of its
/// share in the density of the mixture, from near 0, on the flank of another, to 1, alone.
double prominence(const SpectralHump& hump, const HumpMixture& mixture,
                  const std::vector<SpectralPatch>& patches);

/// The mixture without the humps that mend the shape of others: those of a prominence below a half,
/// the least prominent first.
HumpMixture without_flanks(HumpMixture mixture, const std::vector<SpectralPatch>& patches);

/// Bounds of what a map of that size and pitch can tell.
struct HumpBounds {
  SpectralHump::Parameters low, high;
};
HumpBounds hump_bounds(const Extent& extent);

struct HumpFit {
  HumpMixture mixture;
  double deviance =
      0.0;  // sum over ordinates of P / S + log S; the less the likelier, by 1 per nat
};

/// The likeliest mixture near `start` (Whittle's likelihood, by Fisher scoring with a damping).
///
/// patches  at least one, all with power
HumpFit fitted(const HumpMixture& start, const std::vector<SpectralPatch>& patches,
               const HumpBounds& bounds);

}  // namespace hada
