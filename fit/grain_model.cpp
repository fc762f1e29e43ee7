#include "fit/grain_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/solve.h"
#include "fit/whittle.h"
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
                    const GrainAxis& axis) {
  int n = 64;
  while (n < axis.length + reach_of(sequence, cut)) n *= 2;
  std::vector<double> gain(static_cast<std::size_t>(n));
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k <= n / 2; ++k) {
    const double f = double(k) / n, g = axis_gain(sequence, cut, kernel, f);
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

double clamped_exp(double x) {
  return x < -700.0 ? 0.0 : std::exp(x);
}

/// The spectrum along one axis of the m-th term of the quantising error, folded at Nyquist.
double error_along(double f, double slope, double step, double m) {
  const double narrow = step * step / (2.0 * m * m * std::max(slope, 1e-12));
  // Wide terms are flat: three of their copies on each side hold the rest.
  const int turns = narrow > 20.0 ? 0 : narrow > 4.0 ? 1 : 3;
  double sum = 0.0;
  for (int turn = -turns; turn <= turns; ++turn)
    sum += clamped_exp(-narrow * (f + turn) * (f + turn));
  if (narrow < 0.5) return 1.0;
  return sum * std::sqrt(narrow / pi);  // its integral over all f is 1
}

constexpr std::size_t nuisances = 6;
constexpr std::array<SolverBounds, nuisances> bounds{
    {{-4.0, 1.0}, {-4.0, 1.1}, {-24.0, 0.7}, {-5.0, 0.7}, {-1.0, 1.0}, {-1.0, 1.0}}};

std::vector<double> packed(const GrainNuisance& n) {
  return {std::log(n.variance), std::log(n.blur_px),   std::log(n.floor),
          std::log(n.step),     std::log(n.steeper_x), std::log(n.steeper_y)};
}

GrainNuisance unpacked(const double* p) {
  return {std::exp(p[0]), std::exp(p[1]), std::exp(p[2]),
          std::exp(p[3]), std::exp(p[4]), std::exp(p[5])};
}

}  // namespace

GrainModel grain_model(const std::string& sequence, HammerKernel kernel,
                       const GrainSpectrum& spectrum) {
  auto along = seen_along(sequence, 'C', kernel, spectrum.x);
  auto down = seen_along(sequence, 'R', kernel, spectrum.y);
  return {sequence,
          std::move(along.cells),
          std::move(down.cells),
          along.variance * down.variance,
          along.slope,
          down.slope};
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

double grain_cost(const GrainModel& model, const GrainNuisance& nuisance,
                  const GrainSpectrum& spectrum) {
  std::vector<double> expected;
  expected_cells(model, nuisance, spectrum, expected);
  double cost = 0.0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (spectrum.count[k] == 0.0) continue;
    const double d = std::log(spectrum.power[k] / expected[k]);
    cost += spectrum.count[k] * (std::exp(d) - 1.0 - d);
  }
  return cost;
}

GrainFit fit_nuisance(const GrainModel& model, const GrainSpectrum& spectrum,
                      const GrainNuisance& start, int most_iterations) {
  const int count = int(spectrum.power.size());
  const auto residuals = [&](const double* p, double* r) {
    std::vector<double> expected;
    expected_cells(model, unpacked(p), spectrum, expected);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const double n = spectrum.count[k];
      r[k] = n == 0.0 ? 0.0
                      : std::sqrt(n) * deviance_residual(std::log(spectrum.power[k] / expected[k]));
    }
  };
  const ResidualFunction evaluate = [&](const double* p, double* r, double* jacobian) {
    residuals(p, r);
    if (!jacobian) return;
    constexpr double h = 1e-5;
    std::vector<double> moved(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < nuisances; ++k) {
      std::array<double, nuisances> q;
      std::copy(p, p + nuisances, q.begin());
      q[k] += h;
      residuals(q.data(), moved.data());
      for (std::size_t i = 0; i < std::size_t(count); ++i)
        jacobian[nuisances * i + k] = (moved[i] - r[i]) / h;
    }
  };
  const auto ending = descend({packed(start)}, {bounds.begin(), bounds.end()}, count, evaluate,
                              {.max_iterations = most_iterations, .tolerance = 1e-7})
                          .front();
  return {unpacked(ending.packed.data()), ending.cost};
}

}  // namespace hada
