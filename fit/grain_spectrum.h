#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "core/grid.h"

namespace hada {

/// One axis of a tapered periodogram, its frequencies k / length gathered in cells.
struct GrainAxis {
  int length = 0;               // pixels
  std::vector<int> edges;       // cell c holds the frequencies edges[c] <= k < edges[c + 1]
  std::vector<double> overlap;  // of the taper with itself at every lag, 1 at lag 0
  int cells() const { return int(edges.size()) - 1; }
};

/// The periodogram of a picture, its positive and negative frequencies taken together.
///
/// The spectrum of grain is a product of one function for each axis. So cells are rectangles: the
/// mean of the expected power over a cell is then the product of two means, exactly.
struct GrainSpectrum {
  GrainAxis x;
  GrainAxis y;
  Grid<double> power;  // mean over a cell, px^2; row: cell of y, col: cell of x
  Grid<double> count;  // independent ordinates in it; 0 for the cells at frequency 0
};

struct GrainSpectrumOptions {
  double taper = 0.25;   // share of the picture's sides over which the taper falls (Tukey)
  int single = 12;       // so many frequencies from 0 on stay alone
  double growth = 0.08;  // size of a cell further out, as a share of its frequency
};

/// Half of the transform of a tapered picture; the squares of its values are power, in px^2.
struct TaperedTransform {
  Grid<std::complex<double>> half;
  double independence = 1.0;  // independent ordinates, as a share of all
};
TaperedTransform tapered_transform(const Grid<float>& scores, double taper);

/// How much ordinate (row, col) of the half of a transform tells: 0 next to frequency 0, which the
/// mean has emptied, 1/2 where its mirror image is in the same half.
double ordinate_weight(int row, int col, int rows, int cols);

/// The cell of every frequency of an axis from 0 to the Nyquist one.
std::vector<int> cell_of_frequency(const GrainAxis& axis);

/// scores  grey values of mean 0
GrainSpectrum grain_spectrum(const Grid<float>& scores, const GrainSpectrumOptions& options = {});

/// The expected periodogram, at every frequency k / length from 0 to the Nyquist one, of grain
/// whose spectral density along this axis is known at f = k / n, k = 0 to n - 1: the density seen
/// through the taper, without bias.
///
/// density  n > length + the lag beyond which the grain does not hang together
///
/// Source: Sykulski et al., The debiased Whittle likelihood, Biometrika 106 (2019).
std::vector<double> seen_through(const GrainAxis& axis, const std::vector<double>& density);

/// Means over the cells of an axis of what is known at each of its frequencies.
///
/// Frequency 0 and the Nyquist one count half, as in the periodogram: all others are there twice,
/// positive and negative.
std::vector<double> cell_means(const GrainAxis& axis, const std::vector<double>& at);

}  // namespace hada
