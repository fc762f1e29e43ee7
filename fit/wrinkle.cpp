#include "fit/wrinkle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/scalar.h"
#include "fit/cells.h"
#include "fit/goodness.h"
#include "fit/solve.h"
#include "fit/wrinkle_starts.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 32;  // along each side: fewer hold too few ordinates to tell shapes
constexpr double least_goodness = 1e-3;  // p below which a person is told
constexpr double cauchy_scale = 3.0;     // deviations beyond which a cell loses its say at first

/// What the fit looks at.
struct Observation {
  Spectrum spectrum;
  std::vector<Cell> coarse;
  std::vector<Cell> fine;
  std::vector<std::string> remarks;
};

/// Taking off the mean empties frequency 0 alone. A plane takes 6 / pi^2 of the power one step away
/// with it; a quadratic nearly all of that, and some of it two steps away.
double steps_emptied_by(const std::string& levelling) {
  if (levelling == "offset") return 0.5;
  return levelling == "plane" ? 1.5 : 2.5;
}

Observation observe(const Surface& surface) {
  Observation seen;
  if (!surface.has_height() && surface.albedo.empty()) {
    throw Error("wrinkle fit: the surface has neither height nor albedo; reconstruct it first");
  }
  if (!surface.has_height()) {
    seen.remarks.push_back(
        "The surface has no height, so the wrinkles describe its brightness: amplitudes are "
        "brightness, not lengths.");
  }
  const auto map = surface.has_height() ? surface.height : luminance(surface.albedo);
  seen.spectrum = power_spectrum(map, surface.mask, surface.extent);
  const Extent& box = seen.spectrum.extent;
  if (box.rows < fewest_pixels || box.cols < fewest_pixels) {
    throw Error("wrinkle fit: the mask is smaller than 32 x 32 pixels; measure a larger sample");
  }
  if (surface.extent.unit == Unit::px) {
    seen.remarks.push_back("The pitch is unknown: lengths and amplitudes count pixels, not mm.");
  }
  const Leakage leaked = leakage(seen.spectrum);
  const double hole = steps_emptied_by(surface.levelling);
  seen.fine = cells_of(seen.spectrum, leaked, {.empty_steps = hole});
  seen.coarse =
      cells_of(seen.spectrum, leaked,
               {.empty_steps = hole, .inner_bins = 10.0, .growth = 0.12, .faintest = 1e-6});
  double highest = 0.0;
  for (const Cell& cell : seen.fine) highest = std::max(highest, cell.power);
  if (!(highest > 0.0)) {
    throw Error("wrinkle fit: the map is flat; there is nothing to fit");
  }
  // A cell that is empty to rounding has no logarithm.
  for (auto* cells : {&seen.coarse, &seen.fine}) {
    for (Cell& cell : *cells) cell.power = std::max(cell.power, 1e-25 * highest);
  }
  return seen;
}

/// The expected power of every cell.
template <class T>
std::vector<T> densities(const Wrinkle<T>& wrinkle, const std::vector<Cell>& cells) {
  std::vector<T> sums;
  for (const Cell& cell : cells) sums.push_back(wrinkle.floor_mm4 + cell.leakage);
  for (const auto& component : wrinkle.components) {
    const auto covariance = autocovariance(component);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell& cell = cells[i];
      const GaussianCovariance<T> seen{covariance.variance, covariance.xx + cell.xx,
                                       covariance.xy + cell.xy, covariance.yy + cell.yy};
      sums[i] += psd(seen, cell.fx, cell.fy);
    }
  }
  return sums;
}

/// A residual whose square grows with the logarithm of r^2 beyond `cauchy_scale`.
template <class T>
T softened(const T& r) {
  using std::log;
  using std::sqrt;
  const T u = r * r / (cauchy_scale * cauchy_scale);
  if (value_of(u) < 1e-6) return r;
  return (value_of(r) < 0.0 ? -cauchy_scale : cauchy_scale) * sqrt(log(1.0 + u));
}

/// sign(d) sqrt(2 (e^d - 1 - d)): half its square is the deviance of an exponential variable whose
/// logarithm exceeds that of its mean by d.
template <class T>
T deviance_residual(const T& d) {
  using std::exp;
  using std::sqrt;
  const double plain = value_of(d);
  // Near 0 by its series, where the difference would cancel; the next term is d^5 / 2520.
  if (std::abs(plain) < 0.1) {
    return d * sqrt(1.0 + d * (1.0 / 3.0 + d * (1.0 / 12.0 + d * (1.0 / 60.0 + d / 360.0))));
  }
  const T root = sqrt(2.0 * (exp(d) - 1.0 - d));
  return plain < 0.0 ? -root : root;
}

/// Stage one: forgiving log ratios, for starts that are far away.
auto log_ratios(const std::vector<Cell>& cells, double independence) {
  return [&cells, independence](const auto& wrinkle, auto* r) {
    using std::log;
    const auto model = densities(wrinkle, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double n = cells[i].count;
      const double bias = 1.0 / (2.0 * n) + 1.0 / (12.0 * n * n);  // of the log of a mean of n
      r[i] =
          softened(std::sqrt(independence * n) * (std::log(cells[i].power) + bias - log(model[i])));
    }
  };
}

/// Stage two: half the sum of squares is the negative logarithm of the Whittle likelihood.
auto deviances(const std::vector<Cell>& cells, double independence) {
  return [&cells, independence](const auto& wrinkle, auto* r) {
    using std::log;
    const auto model = densities(wrinkle, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      r[i] = std::sqrt(independence * cells[i].count) *
             deviance_residual(std::log(cells[i].power) - log(model[i]));
    }
  };
}

/// The same wrinkles as everyone would write them: long >= short, long components first.
Wrinkle<> canonical(Wrinkle<> wrinkle) {
  for (auto& component : wrinkle.components) {
    if (component.long_mm >= component.short_mm) continue;
    std::swap(component.long_mm, component.short_mm);
    component.angle_rad += 0.5 * std::numbers::pi;
  }
  std::stable_sort(wrinkle.components.begin(), wrinkle.components.end(),
                   [](const auto& a, const auto& b) { return a.long_mm > b.long_mm; });
  return wrapped(wrinkle);
}

double half_sum_of_squares(const Wrinkle<>& wrinkle, std::size_t count, const auto& residual) {
  std::vector<double> r(count);
  residual(wrinkle, r.data());
  double sum = 0.0;
  for (const double value : r) sum += 0.5 * value * value;
  return sum;
}

/// Fisher information of the packed fields: sum of kappa n (d ln S)(d ln S)^T.
Eigen::MatrixXd information_of(const Wrinkle<>& wrinkle, const Observation& seen) {
  const auto& cells = seen.fine;
  const auto jacobian = jacobian_of(wrinkle, int(cells.size()), [&](const auto& material, auto* r) {
    using std::log;
    const auto model = densities(material, cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
      r[i] = std::sqrt(seen.spectrum.independence * cells[i].count) * log(model[i]);
  });
  return jacobian.transpose() * jacobian;
}

std::vector<Wrinkle<>> materials(const Wrinkle<>& shape, const std::vector<Ending>& endings) {
  std::vector<Wrinkle<>> result;
  for (const auto& ending : endings) {
    if (std::isfinite(ending.cost)) result.push_back(unpack(shape, ending.packed.data()));
  }
  return result;
}

Fit<Wrinkle<>> fit_from(const std::vector<Wrinkle<>>& starts, const Observation& seen) {
  const double kappa = seen.spectrum.independence;
  const auto rough = materials(
      starts.front(), endings_of(starts, int(seen.coarse.size()), log_ratios(seen.coarse, kappa),
                                 {.max_iterations = 50, .tolerance = 1e-4}));
  const auto whittle = deviances(seen.fine, kappa);
  auto fit =
      solve(rough, int(seen.fine.size()), whittle, {.max_iterations = 60, .tolerance = 1e-7});
  fit.starts = int(starts.size());
  fit.material = canonical(fit.material);

  // A floor that the data cannot tell from none is none.
  Wrinkle<> bare = fit.material;
  bare.floor_mm4 = 0.0;
  const double without = half_sum_of_squares(bare, seen.fine.size(), whittle);
  if (without < fit.cost + 0.01) fit.material = bare;
  set_uncertainty(fit, information_of(fit.material, seen));
  fit.goodness_p = goodness_of_fit(seen.fine, densities(fit.material, seen.fine), kappa,
                                   int(pack(fit.material).size()));
  return fit;
}

std::vector<std::string> remarks_on(const Fit<Wrinkle<>>& fit) {
  std::vector<std::string> remarks;
  for (const auto& path : fit.on_bound) {
    remarks.push_back(path == "floor_mm4"
                          ? "No noise floor can be seen; floor_mm4 lies on its lower bound."
                          : path + " ended on a bound, so that its sigma means nothing.");
  }
  if (fit.agreeing < 2 && fit.starts > 1) {
    remarks.push_back("Only one start of " + std::to_string(fit.starts) +
                      " ended at the best fit; another fit may be as good.");
  }
  if (fit.goodness_p < least_goodness) {
    remarks.push_back(
        "The spectrum departs from that of wrinkle noise by more than chance explains: read the "
        "sigmas as too small.");
  }
  return remarks;
}

double bic(const Fit<Wrinkle<>>& fit, const Observation& seen) {
  double ordinates = 0.0;
  for (const Cell& cell : seen.fine) ordinates += cell.count;
  return 2.0 * fit.cost +
         double(pack(fit.material).size()) * std::log(seen.spectrum.independence * ordinates);
}

}  // namespace

Fit<Wrinkle<>> fit_wrinkle(const Surface& surface, const WrinkleFitOptions& options) {
  const Observation seen = observe(surface);
  const int starts = std::max(options.starts, 6);
  const int fewest = options.components > 0 ? options.components : 1;
  const int most = options.components > 0 ? options.components : options.most_components;
  Fit<Wrinkle<>> best;
  for (int components = fewest; components <= most; ++components) {
    auto from = wrinkle_starts(seen.spectrum, components, starts);
    if (components > fewest) {
      from.push_back(with_one_more(best.material, seen.fine, densities(best.material, seen.fine)));
    }
    auto fit = fit_from(from, seen);
    if (components > fewest && bic(fit, seen) >= bic(best, seen)) break;
    best = std::move(fit);
  }
  best.remarks = seen.remarks;
  for (auto& remark : remarks_on(best)) best.remarks.push_back(std::move(remark));
  return best;
}

}  // namespace hada
