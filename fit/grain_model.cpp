#include "fit/grain_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/fft.h"
#include "synth/forged_spectrum.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// Terms of the series of the quantising error: every one up to 4, then some, each for its
/// neighbours. Together they fall with the third power of the frequency, as sharp edges do.
struct ErrorTerm {
  double m;
  double weight;  // how many terms it stands for
};
constexpr std::array<ErrorTerm, 9> error_terms{
    {{1, 1}, {2, 1}, {3, 1}, {4, 1.5}, {6, 2.5}, {9, 3.5}, {13, 5}, {19, 7.5}, {28, 11}}};

/// A place on each side over which grain hangs together, after all folds.
int reach_of(const std::string& sequence, char cut) {
  int reach = 1, stretched = 0;
  for (auto fold = sequence.rbegin(); fold != sequence.rend(); ++fold) {
    reach += 2 << stretched;
    if (*fold == cut) ++stretched;
  }
  return reach;
}

/// Centres of the cells in cycles per px.
std::vector<double> centres(const GrainAxis& axis) {
  std::vector<double> at;
  for (int c = 0; c < axis.cells(); ++c) {
    const double middle = 0.5 * (axis.edges[std::size_t(c)] + axis.edges[std::size_t(c + 1)] - 1);
    at.push_back(middle / axis.length);
  }
  return at;
}

struct AxisSeen {
  std::vector<double> cells;
  double variance;
  double slope;  // mean square slope over the variance
};

AxisSeen seen_along(const std::string& sequence, char cut, HammerKernel kernel,
                    const GrainAxis& axis, double scale) {
  int n = 64;
  while (n < axis.length + scale * reach_of(sequence, cut)) n *= 2;
  std::vector<double> gain(static_cast<std::size_t>(n));
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k <= n / 2; ++k) {
    const double f = double(k) / n, u = scale * f;
    const double g = u > 0.5 ? 0.0 : axis_gain(sequence, cut, kernel, u);
    gain[std::size_t(k)] = gain[std::size_t(k == 0 ? 0 : n - k)] = g;
    const double both = k == 0 || 2 * k == n ? 1.0 : 2.0;
    sum += both * g / n;
    // Of differences between neighbours: places are all there is.
    squares += both * g / n * (2.0 - 2.0 * std::cos(2.0 * pi * f));
  }
  auto seen = cell_means(axis, seen_through(axis, gain));
  for (double& value : seen) value /= sum;
  return {std::move(seen), sum, squares / sum};
}

/// The spectrum along one axis of the m-th term of the quantising error, folded at Nyquist.
double error_along(double f, double slope, double step, double m) {
  const double narrow = step * step / (2.0 * m * m * std::max(slope, 1e-12));
  if (narrow < 0.5) return 1.0;  // wide terms are flat
  // Copies on each side that reach into the band.
  const int turns = narrow > 20.0 ? 0 : narrow > 4.0 ? 1 : 3;
  double sum = 0.0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double down = narrow * (f + turn) * (f + turn);
    if (down < 40.0) sum += std::exp(-down);
  }
  return sum * std::sqrt(narrow / pi);  // its integral over all f is 1
}

}  // namespace

GrainModel grain_model(const std::string& sequence, HammerKernel kernel,
                       const GrainSpectrum& spectrum, double scale, double aspect) {
  GrainModel model;
  model.sequence = sequence;
  model.kernel = kernel;
  rescale(model, spectrum, scale, aspect);
  return model;
}

void rescale(GrainModel& model, const GrainSpectrum& spectrum, double scale, double aspect) {
  if (model.along.empty() || model.scale_x != scale * aspect) {
    model.scale_x = scale * aspect;
    auto along = seen_along(model.sequence, 'C', model.kernel, spectrum.x, model.scale_x);
    model.along = std::move(along.cells);
    model.variance_x = along.variance;
    model.slope_x = along.slope;
  }
  if (model.down.empty() || model.scale_y != scale) {
    model.scale_y = scale;
    auto down = seen_along(model.sequence, 'R', model.kernel, spectrum.y, model.scale_y);
    model.down = std::move(down.cells);
    model.variance_y = down.variance;
    model.slope_y = down.slope;
  }
  model.variance = model.variance_x * model.variance_y;
}

std::vector<double> grain_covariance(const GrainModel& model, char cut, int places) {
  int n = 64;
  while (n < 2 * places || n < places + reach_of(model.sequence, cut)) n *= 2;
  // No grain beyond the Nyquist frequency of the places: zeros there make the lags finer.
  Grid<double> density(1, covariance_steps * n);
  for (int k = 0; k <= n / 2; ++k) {
    const double g = axis_gain(model.sequence, cut, model.kernel, double(k) / n);
    density(0, k) = density(0, k == 0 ? 0 : density.cols() - k) = 2 * k == n ? 0.5 * g : g;
  }
  const auto lags = fft(density);
  std::vector<double> covariance;
  for (int lag = 0; lag <= covariance_steps * places; ++lag)
    covariance.push_back(lags(0, lag).real() / lags(0, 0).real());
  return covariance;
}

void expected_cells(const GrainModel& model, const GrainNuisance& nuisance,
                    const GrainSpectrum& spectrum, std::vector<double>& expected) {
  const auto fx = centres(spectrum.x), fy = centres(spectrum.y);
  const std::size_t cols = fx.size(), rows = fy.size();
  const double step = nuisance.step / std::sqrt(nuisance.variance);  // in deviations of the grain
  constexpr std::size_t terms = error_terms.size();
  std::vector<double> across(cols * (terms + 1));
  std::vector<double> weights(terms + 1);
  const double blur = -4.0 * pi * pi * nuisance.blur_px * nuisance.blur_px;
  for (std::size_t col = 0; col < cols; ++col) {
    const double seen = std::exp(blur * fx[col] * fx[col]);
    across[col] = model.along[col] * seen;
    for (std::size_t m = 1; m <= terms; ++m) {
      across[m * cols + col] = seen * error_along(fx[col], model.slope_x * nuisance.steeper_x, step,
                                                  error_terms[m - 1].m);
    }
  }
  expected.resize(rows * cols);
  for (std::size_t row = 0; row < rows; ++row) {
    const double seen = std::exp(blur * fy[row] * fy[row]);
    weights[0] = nuisance.variance * model.down[row] * seen;
    for (std::size_t m = 1; m <= terms; ++m) {
      const auto& [number, weight] = error_terms[m - 1];
      weights[m] = seen * weight * nuisance.step * nuisance.step /
                   (2.0 * pi * pi * number * number) *
                   error_along(fy[row], model.slope_y * nuisance.steeper_y, step, number);
    }
    double* out = &expected[row * cols];
    for (std::size_t col = 0; col < cols; ++col) out[col] = nuisance.floor;
    for (std::size_t m = 0; m <= terms; ++m) {
      for (std::size_t col = 0; col < cols; ++col) out[col] += weights[m] * across[m * cols + col];
    }
  }
}

GrainNuisance carried_over(GrainNuisance nuisance, const GrainModel& from, const GrainModel& to) {
  nuisance.steeper_x *= from.slope_x / to.slope_x;
  nuisance.steeper_y *= from.slope_y / to.slope_y;
  return nuisance;
}

double grain_cost(const GrainModel& model, const GrainNuisance& nuisance,
                  const GrainSpectrum& spectrum) {
  std::vector<double> expected;
  expected_cells(model, nuisance, spectrum, expected);
  const double x = std::log(nuisance.steeper_x) / log_steeper_sigma;
  const double y = std::log(nuisance.steeper_y) / log_steeper_sigma;
  double cost = 0.5 * (x * x + y * y);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (spectrum.count[k] == 0.0) continue;
    const double d = std::log(spectrum.power[k] / expected[k]);
    cost += spectrum.count[k] * (std::exp(d) - 1.0 - d);
  }
  return cost;
}

}  // namespace hada
