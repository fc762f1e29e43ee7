#pragma once

#include <array>
#include <string>
#include <vector>

#include "fit/grain_spectrum.h"
#include "synth/forged.h"

namespace hada {

/// What a picture does to grain, besides its tone: all that is fitted along with a sequence.
struct GrainNuisance {
  double variance = 0.9;   // of the grain, as a share of the picture
  double blur_px = 0.3;    // standard deviation of a Gaussian
  double floor = 0.02;     // variance of white noise
  double step = 0.3;       // between neighbouring levels, in standard deviations of the picture
  double steeper_x = 1.0;  // mean square slope at the edges of levels, over that of the model
  double steeper_y = 1.0;
};

/// The grain of one sequence as the cells of a periodogram are expected to see it.
struct GrainModel {
  std::string sequence;
  std::vector<double> along;  // mean expected power of the cells of x, for grain of variance 1
  std::vector<double> down;   // of y, the product of both a power spectral density in px^2
  double variance = 1.0;      // of the grain of a block whose numbers have variance 1
  double slope_x = 0.0;       // mean square slope along x over the variance, 1/px^2
  double slope_y = 0.0;
};

GrainModel grain_model(const std::string& sequence, HammerKernel kernel,
                       const GrainSpectrum& spectrum);

/// The expected power of every cell, rows of y, cells of x.
///
/// Quantising a normal field of step d adds an error whose autocovariance is
/// sum_m d^2 / (2 pi^2 m^2) exp(-4 pi^2 m^2 (1 - rho) / d^2); with rho = 1 minus a quadratic form
/// of the lag each term and its spectrum are Gaussians. The slopes at the edges of levels are not
/// those of the mean place, so that their squares are nuisances too.
///
/// Source: Widrow and Kollar, Quantization Noise (2008), chapter 9; Bennett, Bell System Technical
/// Journal 27 (1948), for the spectrum.
void expected_cells(const GrainModel& model, const GrainNuisance& nuisance,
                    const GrainSpectrum& spectrum, std::vector<double>& expected);

/// How well a sequence explains a periodogram, with the nuisance that suits it best.
struct GrainFit {
  GrainNuisance nuisance;
  double cost = 0.0;  // half the deviance of the Whittle likelihood
};

/// Half the deviance at a given nuisance.
double grain_cost(const GrainModel& model, const GrainNuisance& nuisance,
                  const GrainSpectrum& spectrum);

/// The nuisance with the least deviance, by bounded descent from `start`.
GrainFit fit_nuisance(const GrainModel& model, const GrainSpectrum& spectrum,
                      const GrainNuisance& start, int most_iterations);

}  // namespace hada
