#include "measure/polar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/field.h"
#include "measure/chi_squared.h"
#include "measure/half_plane.h"

namespace hada {
namespace {

/// What falls into one ring or sector.
struct Bin {
  double sum = 0.0;
  double sum_of_squares = 0.0;
  double count = 0.0;

  /// `share` of an ordinate falls into this one.
  void add(double power, int times, double share = 1.0) {
    sum += times * share * power;
    sum_of_squares += times * share * share * power * power;
    count += times * share;
  }
  double density() const { return count > 0.0 ? sum / count : 0.0; }
  /// An ordinate is exponentially distributed, so that its variance is half its mean square; it
  /// comes twice (at f and at -f), and a taper leaves the part `independence` of the ordinates.
  double sigma(double independence) const {
    return count > 0.0 ? std::sqrt(sum_of_squares / independence) / count : 0.0;
  }
};

double nyquist(const Spectrum& spectrum) {
  return 0.5 / spectrum.extent.pitch;
}

/// Calls visit(fx, fy, radius, power, times) for every ordinate of half a plane inside the Nyquist
/// circle but the mean, as `visit_half_plane`.
template <class Visit>
void visit_ordinates(const Spectrum& spectrum, const Visit& visit) {
  const double most = nyquist(spectrum);
  visit_half_plane(spectrum, most, most, [&](int row, int col, double fx, double fy, int times) {
    const double radius = std::sqrt(fx * fx + fy * fy);
    if (radius < most) visit(fx, fy, radius, spectrum.power(row, col), times);
  });
}

template <class Summary>
void append(Summary& summary, const Bin& bin, const Spectrum& spectrum) {
  const double area = spectrum.extent.width() * spectrum.extent.height();
  summary.power.push_back(bin.sum / area);
  summary.density.push_back(bin.density());
  const double sigma = bin.sigma(spectrum.independence);
  summary.sigma.push_back(sigma);
  const Interval interval = power_interval(bin.density(), sigma);
  summary.low.push_back(interval.low);
  summary.high.push_back(interval.high);
  summary.count.push_back(int(std::lround(bin.count)));
}

}  // namespace

Rings rings(const Spectrum& spectrum, int count) {
  // A ring thinner than the step of the frequencies would be empty.
  const int most = std::min(spectrum.extent.rows, spectrum.extent.cols) / 2;
  std::vector<Bin> bins(std::size_t(std::clamp(count, 1, most)));
  const double width = nyquist(spectrum) / double(bins.size());
  visit_ordinates(spectrum, [&](double, double, double radius, double power, int times) {
    bins[std::min(std::size_t(radius / width), bins.size() - 1)].add(power, times);
  });
  Rings result;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    result.frequency.push_back((double(k) + 0.5) * width);
    append(result, bins[k], spectrum);
  }
  return result;
}

Sectors sectors(const Spectrum& spectrum, int count, double low, double high) {
  std::vector<Bin> bins(std::size_t(std::max(count, 1)));
  const double width = std::numbers::pi / double(bins.size());
  const double step = 1.0 / std::sqrt(spectrum.extent.width() * spectrum.extent.height());
  visit_ordinates(spectrum, [&](double fx, double fy, double radius, double power, int times) {
    if (radius < low || radius >= high) return;
    const double angle = half_turn(std::atan2(fy, fx));
    const double half = std::min(0.5 * step / radius, 0.25 * std::numbers::pi);
    const double from = (angle - half) / width, to = (angle + half) / width;
    for (int k = int(std::floor(from)); k < to; ++k) {
      const double share = (std::min(to, k + 1.0) - std::max(from, double(k))) / (to - from);
      const int n = int(bins.size());
      bins[std::size_t((k % n + n) % n)].add(power, times, share);
    }
  });
  Sectors result;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    result.angle.push_back((double(k) + 0.5) * width);
    append(result, bins[k], spectrum);
  }
  return result;
}

std::vector<int> peaks(const std::vector<double>& power, int most, bool cyclic) {
  const int n = int(power.size());
  const auto at = [&](int k) {
    if (cyclic) return power[std::size_t((k + n) % n)];
    return k < 0 || k >= n ? -HUGE_VAL : power[std::size_t(k)];
  };
  std::vector<int> found;
  for (int k = 0; k < n; ++k) {
    if (at(k) > at(k - 1) && at(k) >= at(k + 1)) found.push_back(k);
  }
  std::stable_sort(found.begin(), found.end(), [&](int a, int b) { return at(a) > at(b); });
  if (int(found.size()) > most) found.resize(std::size_t(std::max(most, 0)));
  return found;
}

}  // namespace hada
