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
  double scale = 1.0;   // pixels for a place of the block, down the picture
  double aspect = 1.0;  // the same along the rows, over `scale`
};

/// The grain of one sequence as the cells of a periodogram are expected to see it.
struct GrainModel {
  std::string sequence;
  std::vector<double> along;  // mean expected power of the cells of x, for grain of variance 1
  std::vector<double> down;   // of y, the product of both a power spectral density in px^2
  double variance = 1.0;      // of the grain of a block whose numbers have variance 1
  double variance_x = 1.0;    // its factors for both axes
  double variance_y = 1.0;
  double slope_x = 0.0;  // mean square slope along x over the variance, 1/px^2
  double slope_y = 0.0;
  HammerKernel kernel = HammerKernel::both;
  double scale_x = 1.0;  // pixels for a place
  double scale_y = 1.0;
};

/// scale  pixels for a place; beyond the Nyquist frequency of the places there is no grain
GrainModel grain_model(const std::string& sequence, HammerKernel kernel,
                       const GrainSpectrum& spectrum, double scale = 1.0, double aspect = 1.0);

/// The same grain at another scale.
void rescale(GrainModel& model, const GrainSpectrum& spectrum, double scale, double aspect);

/// The autocovariance along one axis of grain of variance 1, at lags of a whole number of eighths
/// of a place, up to `places`. cut  the letter that stretches along this axis
std::vector<double> grain_covariance(const GrainModel& model, char cut, int places);
constexpr int covariance_steps = 8;  // of a place

/// Of the logarithms of `steeper_x` and `steeper_y` beforehand: true sequences have them within
/// 0.2.
constexpr double log_steeper_sigma = 0.3;

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

/// The nuisance of a picture as the model of another sequence takes it: the slopes at the edges of
/// levels stay as they are seen, and so change over those of the model.
GrainNuisance carried_over(GrainNuisance nuisance, const GrainModel& from, const GrainModel& to);

/// Half the deviance at a given nuisance, and what its slopes cost: the logarithms of `steeper_x`
/// and `steeper_y` are normal beforehand.
double grain_cost(const GrainModel& model, const GrainNuisance& nuisance,
                  const GrainSpectrum& spectrum);

}  // namespace hada
