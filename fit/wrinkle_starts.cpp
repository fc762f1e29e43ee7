#include "fit/wrinkle_starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "measure/polar.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double profile_step = 1.2;  // ratio of neighbouring frequencies of a profile
constexpr int bands = 6;              // of frequencies, for directions
constexpr double faintest = 1e-6;     // share of the highest density at which a profile ends

/// Density over frequency, in equal steps of its logarithm: fine rings, pooled further out.
struct Profile {
  std::vector<double> frequency, density, power;
  double floor = 0.0;
};

Profile profile_of(const Spectrum& spectrum) {
  const auto fine = rings(spectrum, std::min(spectrum.extent.rows, spectrum.extent.cols) / 2);
  Profile profile;
  for (std::size_t k = 1; k < fine.power.size();) {
    double sum = 0.0, power = 0.0, moment = 0.0;
    int count = 0;
    const double limit = fine.frequency[k] * profile_step;
    do {
      sum += fine.density[k] * fine.count[k];
      moment += fine.frequency[k] * fine.count[k];
      power += fine.power[k];
      count += fine.count[k];
      ++k;
    } while (k < fine.power.size() && fine.frequency[k] < limit);
    profile.frequency.push_back(moment / count);
    profile.density.push_back(sum / count);
    profile.power.push_back(power);
  }
  profile.floor = *std::min_element(profile.density.begin(), profile.density.end());
  const double highest = *std::max_element(profile.density.begin(), profile.density.end());
  const double end = std::max(3.0 * profile.floor, faintest * highest);
  std::size_t last = profile.density.size();
  while (last > 2 && profile.density[last - 1] < end) --last;
  for (auto* values : {&profile.frequency, &profile.density, &profile.power}) values->resize(last);
  return profile;
}

/// How a start shares out frequencies among its components: the weight of each step of a profile.
std::vector<double> weights(const Profile& profile, int rule) {
  std::vector<double> weight;
  for (std::size_t k = 0; k < profile.density.size(); ++k) {
    const std::size_t next = std::min(k + 1, profile.density.size() - 1);
    const double fall = std::log(profile.density[k] / profile.density[next]);
    weight.push_back(std::array{1.0, std::max(fall, 0.0) + 0.01, profile.power[k]}.at(rule));
  }
  return weight;
}

std::size_t quantile(const std::vector<double>& weight, double share) {
  double total = 0.0, sum = 0.0;
  for (const double w : weight) total += w;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    sum += weight[k];
    if (sum >= share * total) return k;
  }
  return weight.size() - 1;
}

/// Direction and axis ratio of the power that `sectors` hold.
struct Direction {
  double angle_rad;  // of the long axis
  double ratio;      // of the axes, >= 1
};

/// A Gaussian spectrum with axis ratio q has mean exp(2 i angle) = (q - 1) / (q + 1).
double axis_ratio(std::complex<double> doubled) {
  const double r = std::min(std::abs(doubled), 0.6);
  return std::max((1.0 + r) / (1.0 - r), 1.2);
}

Direction direction_of(const Sectors& sectors, int rank) {
  std::complex<double> doubled = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < sectors.power.size(); ++k) {
    doubled += std::polar(sectors.power[k], 2.0 * sectors.angle[k]);
    sum += sectors.power[k];
  }
  const auto best = peaks(sectors.power, rank + 1, true);
  const double across = best.empty() ? 0.0 : sectors.angle[std::size_t(best.back())];
  return {half_turn(across + pi / 2), axis_ratio(sum > 0.0 ? doubled / sum : 0.0)};
}

/// The noise function whose density has fallen to 1/e of its peak at `frequency`, and is `density`.
WrinkleComponent<> component_at(double frequency, double density, const Direction& direction) {
  const double length = 1.0 / (2.0 * pi * frequency);
  const double stretch = std::sqrt(direction.ratio);
  return {.amplitude_mm = std::sqrt(density * std::numbers::e / (4.0 * pi * length * length)),
          .long_mm = length * stretch,
          .short_mm = length / stretch,
          .angle_rad = direction.angle_rad};
}

}  // namespace

Wrinkle<> within_bounds(Wrinkle<> wrinkle) {
  visit_fields(wrinkle, [](const std::string&, const auto& field, double& value) {
    if (field.scale == Scale::log)
      value = std::clamp(value, std::max(field.low, 1e-15 * field.high), field.high);
  });
  return wrinkle;
}

std::vector<Wrinkle<>> wrinkle_starts(const Spectrum& spectrum, int components, int starts) {
  const Profile profile = profile_of(spectrum);
  const double low = profile.frequency.front(), high = profile.frequency.back() * profile_step;
  std::vector<Sectors> by_band;
  for (int band = 0; band < bands; ++band) {
    const auto edge = [&](double k) { return low * std::pow(high / low, k / bands); };
    by_band.push_back(sectors(spectrum, 18, edge(band) / 1.5, edge(band + 1) * 1.5));
  }
  const auto direction_at = [&](double frequency, int rank) {
    const double share = std::log(frequency / low) / std::log(high / low);
    return direction_of(by_band[std::size_t(std::clamp(int(share * bands), 0, bands - 1))], rank);
  };

  std::vector<Wrinkle<>> result;
  for (int start = 0; start < starts; ++start) {
    const auto weight = weights(profile, start % 3);
    const double shift = std::array{0.5, 0.25, 0.75, 0.4, 0.6}.at(std::size_t(start / 3 % 5));
    Wrinkle<> wrinkle{.components = {}, .floor_mm4 = profile.floor};
    for (int k = 0; k < components; ++k) {
      const auto at = quantile(weight, (k + shift) / components);
      // From the second round on, neighbours look along different peaks of the sectors.
      const int rank = start < 3 ? 0 : (start + k) % 2;
      const double frequency = profile.frequency[at];
      wrinkle.components.push_back(
          component_at(frequency, profile.density[at], direction_at(frequency, rank)));
    }
    result.push_back(within_bounds(wrinkle));
  }
  return result;
}

Wrinkle<> with_one_more(const Wrinkle<>& wrinkle, const std::vector<Cell>& cells,
                        const std::vector<double>& model) {
  // Bands of a third of an octave; the one whose excess is least likely gets the new component.
  struct Band {
    double measured = 0.0, explained = 0.0, log_frequency = 0.0;
    std::complex<double> doubled = 0.0;
    double excess = 0.0;
    int count = 0;
  };
  constexpr double per_octave = 3.0;
  std::vector<Band> by_frequency;
  double lowest = HUGE_VAL;
  for (const Cell& cell : cells) lowest = std::min(lowest, std::hypot(cell.fx, cell.fy));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const double frequency = std::hypot(cell.fx, cell.fy);
    const auto k = std::size_t(per_octave * std::log2(frequency / lowest));
    if (k >= by_frequency.size()) by_frequency.resize(k + 1);
    Band& band = by_frequency[k];
    const double excess = std::max(cell.power - model[i], 0.0) * cell.count;
    band.measured += cell.count * cell.power;
    band.explained += cell.count * model[i];
    band.log_frequency += cell.count * std::log(frequency);
    band.doubled += std::polar(excess, 2.0 * std::atan2(cell.fy, cell.fx));
    band.excess += excess;
    band.count += cell.count;
  }
  const auto surprise = [](const Band& band) {
    const double ratio = band.measured / band.explained;
    return ratio > 1.0 ? band.count * (ratio - 1.0 - std::log(ratio)) : 0.0;
  };
  const auto worst =
      std::max_element(by_frequency.begin(), by_frequency.end(),
                       [&](const Band& a, const Band& b) { return surprise(a) < surprise(b); });
  const double density = worst->excess / std::max(worst->count, 1);
  const double frequency = std::exp(worst->log_frequency / std::max(worst->count, 1));
  const auto mean = worst->excess > 0.0 ? worst->doubled / worst->excess : 0.0;
  Wrinkle<> more = wrinkle;
  more.components.push_back(component_at(
      frequency, density, {half_turn(0.5 * std::arg(mean) + pi / 2), axis_ratio(mean)}));
  return within_bounds(more);
}

}  // namespace hada
