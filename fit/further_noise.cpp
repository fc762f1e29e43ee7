#include "fit/further_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "fit/solve.h"
#include "fit/spectral_distance.h"
#include "fit/whittle.h"
#include "measure/cepstrum.h"

namespace hada {
namespace {

// Where a search begins; half as many again of the last two lead no nearer.
constexpr int drawn_plain = 20;
constexpr int most_periods = 8;
constexpr int drawn_of_each_period = 6;
constexpr int woven_periods = 6;  // the most pronounced, each with each that goes another way
constexpr int drawn_of_each_pair = 3;
constexpr double another_way = 0.35;  // sine of the angle between two periods
constexpr std::size_t kept = 6;
constexpr double shortest_px = 2.0;     // period: the lines of a shorter one lie beyond Nyquist's
constexpr double longest_share = 0.06;  // of the smaller side: lines are 16 steps apart
constexpr double pi = std::numbers::pi;
const SolveOptions a_little{.max_iterations = 4, .tolerance = 1e-2};
const SolveOptions quickly{.max_iterations = 15, .tolerance = 1e-3};

/// Sizes that a picture can show.
struct Range {
  double low, high;

  double at(double share) const { return low * std::pow(high / low, share); }
};

WrinkleComponent<> drawn(const Extent& extent, double amplitude, Seed seed) {
  const double side = std::min(extent.width(), extent.height());
  const double length = Range{0.3 * extent.pitch, 0.05 * side}.at(uniform(seed, 0));
  const double stretch = std::exp(1.5 * uniform(seed, 1));
  return {.amplitude_mm = amplitude * std::pow(10.0, -uniform(seed, 2)),
          .long_mm = length * stretch,
          .short_mm = length / stretch,
          .angle_rad = pi * uniform(seed, 3)};
}

RepeatedNoise<> repeated(const WrinkleComponent<>& kernel, const Eigen::Vector2d& period,
                         Seed seed) {
  return {.amplitude_mm = kernel.amplitude_mm,
          .long_mm = kernel.long_mm,
          .short_mm = kernel.short_mm,
          .angle_rad = kernel.angle_rad,
          .period_mm = period.norm(),
          .period_angle_rad = half_turn(std::atan2(period.y(), period.x())),
          .repeats = Range{0.7, 3.0}.at(uniform(seed, 4))};
}

WovenNoise<> woven(const WrinkleComponent<>& kernel, const Eigen::Vector2d& period,
                   const Eigen::Vector2d& other, Seed seed) {
  const auto one = repeated(kernel, period, seed), two = repeated(kernel, other, mixed(seed, 1));
  return {.amplitude_mm = kernel.amplitude_mm,
          .long_mm = kernel.long_mm,
          .short_mm = kernel.short_mm,
          .angle_rad = kernel.angle_rad,
          .period_mm = one.period_mm,
          .period_angle_rad = one.period_angle_rad,
          .repeats = one.repeats,
          .other_period_mm = two.period_mm,
          .other_period_angle_rad = two.period_angle_rad,
          .other_repeats = two.repeats};
}

/// The most pronounced of `from`, each with each that goes another way.
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs_of(
    const std::vector<Eigen::Vector2d>& from) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs;
  const auto most = std::min(from.size(), std::size_t(woven_periods));
  for (std::size_t j = 1; j < most; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const auto &one = from[i], &two = from[j];
      const double area = std::abs(one.x() * two.y() - one.y() * two.x());
      if (area > another_way * one.norm() * two.norm()) pairs.emplace_back(one, two);
    }
  }
  return pairs;
}

/// Some of the cells, anywhere: enough to tell where a search leads.
std::vector<Cell> some_of(const std::vector<Cell>& cells) {
  constexpr std::uint64_t one_of = 4;
  constexpr std::size_t few = 2000;
  if (cells.size() < few) return cells;
  std::vector<Cell> some;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (hash(0, std::int64_t(i)) % one_of == 0) some.push_back(cells[i]);
  return some;
}

/// What a noise function alone leaves of the distances, the power of all others being known.
struct DistancesOfOne {
  std::vector<Cell> cells;
  std::vector<double> others;  // what cells receive of them
  LogDistance distance;

  template <class Noise, class T>
  void operator()(const Noise& noise, T* r) const {
    DensityIn density(autocovariance(noise));
    for (std::size_t i = 0; i < cells.size(); ++i)
      r[i] = distance(cells[i], T(others[i] + density(cells[i])));
  }

  /// Looks at each cell once for all fields.
  template <template <class> class Noise>
  void evaluate(const Noise<double>& shape, const double* packed, double* residuals,
                double* jacobian) const {
    constexpr int fields = int(Noise<double>::fields().size());
    DensityIn density_in(autocovariance(unpack(shape, seeded<fields>(packed).data())));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto density = density_in(cells[i]);
      const auto r = distance(cells[i], ceres::Jet<double, 1>(others[i] + density.a, 0));
      residuals[i] = r.a;
      for (int k = 0; k < fields; ++k) jacobian[int(i) * fields + k] = r.v[0] * density.v[k];
    }
  }
};

struct Found {
  Wrinkle<> wrinkle;
  double cost;
};

/// Where `starts` lead: all a little way, the nearest third of them further.
template <class Noise>
void search(const std::vector<Noise>& starts, const DistancesOfOne& distances,
            const Wrinkle<>& wrinkle, const Extent& extent, std::vector<Noise> Wrinkle<>::*list,
            std::vector<Found>& found) {
  const auto bounds = seen_bounds_of(starts.front(), extent);
  const int count = int(distances.cells.size());
  auto endings = endings_of(starts, bounds, count, distances, a_little);
  std::stable_sort(endings.begin(), endings.end(),
                   [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
  endings.resize(std::max(endings.size() / 3, std::min(endings.size(), kept)));
  std::vector<Noise> promising;
  for (const Ending& ending : endings) {
    if (std::isfinite(ending.cost))
      promising.push_back(unpack(starts.front(), ending.packed.data()));
  }
  for (const Ending& ending : endings_of(promising, bounds, count, distances, quickly)) {
    found.push_back({wrinkle, ending.cost});
    (found.back().wrinkle.*list).push_back(unpack(starts.front(), ending.packed.data()));
  }
}

}  // namespace

int periods(const Wrinkle<>& wrinkle) {
  return int(wrinkle.repeated.size() + 2 * wrinkle.woven.size());
}

double weighed(double cost, const Wrinkle<>& wrinkle) {
  constexpr double price = 1.01;
  return cost * std::pow(price, periods(wrinkle));
}

std::vector<Wrinkle<>> with_further_noise(const Wrinkle<>& wrinkle, const Observation& seen,
                                          Seed seed) {
  const Extent& extent = seen.spectrum.extent;
  auto cells = some_of(seen.square);
  auto others = densities(wrinkle, cells);
  const DistancesOfOne distances{std::move(cells), std::move(others), {seen.spectrum.independence}};
  double power = 0.0;
  for (const Cell& cell : seen.square) power += 2.0 * cell.power * cell.count;  // f and -f
  const double amplitude = std::sqrt(power / (extent.width() * extent.height()));
  std::vector<WrinkleComponent<>> plain;
  for (int i = 0; i < drawn_plain; ++i) plain.push_back(drawn(extent, amplitude, mixed(seed, i)));
  const double side = std::min(extent.width(), extent.height());
  const GaussianWindow taper{seen.spectrum.window_x, 0.0, seen.spectrum.window_y};
  const auto distances_back =
      repetitions(seen.spectrum, spectrum_of(wrinkle, taper), shortest_px * extent.pitch,
                  longest_share * side, most_periods);
  std::vector<RepeatedNoise<>> repeating;
  for (const auto& period : distances_back) {
    for (int i = 0; i < drawn_of_each_period; ++i) {
      const Seed other = mixed(mixed(seed, -1), std::int64_t(repeating.size()));
      repeating.push_back(repeated(drawn(extent, amplitude, other), period, other));
    }
  }
  std::vector<WovenNoise<>> weaves;
  for (const auto& [one, two] : pairs_of(distances_back)) {
    for (int i = 0; i < drawn_of_each_pair; ++i) {
      const Seed other = mixed(mixed(seed, -2), std::int64_t(weaves.size()));
      weaves.push_back(woven(drawn(extent, amplitude, other), one, two, other));
    }
  }
  std::vector<Found> found;
  search(plain, distances, wrinkle, extent, &Wrinkle<>::components, found);
  // One that repeats itself needs another beside it, of what does not.
  if (!wrinkle.components.empty() && !repeating.empty())
    search(repeating, distances, wrinkle, extent, &Wrinkle<>::repeated, found);
  if (!wrinkle.components.empty() && !weaves.empty())
    search(weaves, distances, wrinkle, extent, &Wrinkle<>::woven, found);
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return weighed(a.cost, a.wrinkle) < weighed(b.cost, b.wrinkle);
  });
  std::vector<Wrinkle<>> best;
  for (std::size_t i = 0; i < found.size() && i < kept; ++i) best.push_back(found[i].wrinkle);
  return best;
}

}  // namespace hada
