#include "measure/bands.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/bounding_box.h"
#include "core/fft.h"
#include "core/field.h"
#include "core/parallel.h"
#include "measure/spectral_hills.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double broad_anisotropy = 0.8;  // 1: a single direction
constexpr double same_frequency = 0.15;   // ratio, as a logarithm
constexpr int sharing_rounds = 8;
constexpr double light_taper = 0.1;
constexpr double least_taper = 0.3;  // where what was tapered can be given back

/// What the ordinates of a band add up to.
struct Sums {
  double power = 0.0, squares = 0.0, frequency = 0.0, frequency2 = 0.0;
  std::complex<double> doubled = 0.0;
};

// share  of the power at (row, col) that counts
template <class Share>
Sums sums_over(const Spectrum& spectrum, const Share& share) {
  Sums sums;
  for (int row = 0; row < spectrum.power.rows(); ++row) {
    for (int col = 0; col < spectrum.power.cols(); ++col) {
      const double power = share(row, col) * spectrum.power(row, col);
      if (!(power > 0.0)) continue;
      const double fx = spectrum.fx(col), fy = spectrum.fy(row), f = std::hypot(fx, fy);
      sums.power += power;
      sums.squares += power * power;
      sums.frequency += power * f;
      sums.frequency2 += power * f * f;
      sums.doubled += std::polar(power, 2.0 * std::atan2(fy, fx));
    }
  }
  return sums;
}

// The waves of one band alone: filtered out of the tapered map, the taper taken off again where it
// is not too thin.
Grid<float> waves_of(const Grid<std::complex<double>>& transform, const Grid<float>& share,
                     const Grid<double>& taper) {
  auto part = transform;
  for (int row = 0; row < part.rows(); ++row) {
    for (int col = 0; col < part.cols(); ++col) part(row, col) *= double(share(row, col));
  }
  const auto tapered = inverse_fft(part, taper.cols());
  Grid<float> waves(taper.rows(), taper.cols());
  for (std::size_t i = 0; i < waves.size(); ++i) {
    if (taper[i] >= least_taper) waves[i] = float(tapered[i] / taper[i]);
  }
  return waves;
}

Grid<std::complex<double>> transform_of(const Spectrum& spectrum, const Grid<float>& map,
                                        const Mask& mask) {
  const PixelBox box = bounding_box(mask);
  const auto part = crop(map, box.row, box.col, box.rows, box.cols);
  const auto& taper = spectrum.taper;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < taper.size(); ++i) {
    if (!(taper[i] > 0.0)) continue;
    sum += taper[i] * part[i];
    weights += taper[i];
  }
  Grid<double> tapered(part.rows(), part.cols());
  for (std::size_t i = 0; i < taper.size(); ++i) {
    if (taper[i] > 0.0) tapered[i] = taper[i] * (part[i] - sum / weights);
  }
  return fft(tapered);
}

/// A hump over the logarithm of the frequency and the angle: a Gaussian of its own mean and
/// covariance, as high as its power.
struct Hump {
  double power = 0.0;
  double log_frequency = 0.0, angle = 0.0;
  double precision_ff = 0.0, precision_fa = 0.0, precision_aa = 0.0;

  double height(double log_f, double theta) const {
    const double u = log_f - log_frequency;
    const double v = std::remainder(theta - angle, pi);
    const double quadratic =
        precision_ff * u * u + 2.0 * precision_fa * u * v + precision_aa * v * v;
    return power *
           std::sqrt(std::max(precision_ff * precision_aa - precision_fa * precision_fa, 0.0)) *
           std::exp(-0.5 * quadratic);
  }
};

struct Ordinate {
  int row, col;
  double log_frequency, angle, power;
};

// The ordinates of half a plane that belong to any band.
std::vector<Ordinate> ordinates_of(const Spectrum& spectrum, const Grid<int>& band) {
  std::vector<Ordinate> ordinates;
  for (int row = 0; row < band.rows(); ++row) {
    for (int col = 0; col <= band.cols() / 2; ++col) {
      if (band(row, col) < 0) continue;
      const double fx = spectrum.fx(col), fy = spectrum.fy(row);
      ordinates.push_back({row, col, std::log(std::hypot(fx, fy)), half_turn(std::atan2(fy, fx)),
                           spectrum.power(row, col)});
    }
  }
  return ordinates;
}

// share  of every ordinate's power that is the hump's
Hump hump_of(const std::vector<Ordinate>& ordinates, const std::vector<float>& share) {
  Hump hump;
  std::complex<double> doubled = 0.0;
  for (std::size_t i = 0; i < ordinates.size(); ++i) {
    const double power = share[i] * ordinates[i].power;
    hump.power += power;
    hump.log_frequency += power * ordinates[i].log_frequency;
    doubled += std::polar(power, 2.0 * ordinates[i].angle);
  }
  hump.log_frequency /= hump.power;
  hump.angle = 0.5 * std::arg(doubled);
  double ff = 1e-6, fa = 0.0, aa = 1e-6;
  for (std::size_t i = 0; i < ordinates.size(); ++i) {
    const double power = share[i] * ordinates[i].power / hump.power;
    const double u = ordinates[i].log_frequency - hump.log_frequency;
    const double v = std::remainder(ordinates[i].angle - hump.angle, pi);
    ff += power * u * u;
    fa += power * u * v;
    aa += power * v * v;
  }
  const double det = ff * aa - fa * fa;
  hump.precision_ff = aa / det;
  hump.precision_fa = -fa / det;
  hump.precision_aa = ff / det;
  return hump;
}

// Which share of every ordinate belongs to which band: first all to the hill that it lies on, then
// by the humps that the bands make (expectation and maximisation over the measured power).
std::vector<std::vector<float>> shares_of(const std::vector<Ordinate>& ordinates,
                                          const Grid<int>& band, const std::vector<int>& numbers) {
  std::vector<std::vector<float>> shares(numbers.size(),
                                         std::vector<float>(ordinates.size(), 0.0f));
  for (std::size_t i = 0; i < ordinates.size(); ++i) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      shares[k][i] = band(ordinates[i].row, ordinates[i].col) == numbers[k] ? 1.0f : 0.0f;
  }
  for (int round = 0; round < sharing_rounds; ++round) {
    std::vector<Hump> humps;
    for (const auto& share : shares) humps.push_back(hump_of(ordinates, share));
    for_each_index(int(ordinates.size()), [&](int i) {
      const Ordinate& at = ordinates[std::size_t(i)];
      double sum = 1e-300;
      std::vector<double> heights;
      for (const Hump& hump : humps) {
        heights.push_back(hump.height(at.log_frequency, at.angle));
        sum += heights.back();
      }
      for (std::size_t k = 0; k < humps.size(); ++k)
        shares[k][std::size_t(i)] = float(heights[k] / sum);
    });
  }
  return shares;
}

// The shares of one band as a map over half a plane, as a transform has it.
Grid<float> share_map(const std::vector<Ordinate>& ordinates, const std::vector<float>& share,
                      const Spectrum& spectrum) {
  Grid<float> map(spectrum.power.rows(), spectrum.power.cols() / 2 + 1);
  for (std::size_t i = 0; i < ordinates.size(); ++i)
    map(ordinates[i].row, ordinates[i].col) = share[i];
  return map;
}

// Waves whose power is multiplied by their frequency tell the mean frequency pixel by pixel. A
// spectrum of the cut waves would tell it too high: its side lobes reach far up.
Grid<float> times_root_frequency(Grid<float> share, const Spectrum& spectrum) {
  for (int row = 0; row < share.rows(); ++row) {
    for (int col = 0; col < share.cols(); ++col)
      share(row, col) *= float(std::sqrt(std::hypot(spectrum.fx(col), spectrum.fy(row))));
  }
  return share;
}

double root_mean_square(const Grid<float>& values, const Mask& mask) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) continue;
    sum += double(values[i]) * values[i];
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

// mean         frequency, every pixel alike
// independent  how many independent observations the band rests on
Band band_from(const Sums& sums, double rms, double mean, double independent) {
  Band band;
  const double of_cut = sums.frequency / sums.power;
  const double spread = std::max(sums.frequency2 / sums.power - of_cut * of_cut, 0.0);
  const double coherence = std::abs(sums.doubled) / sums.power;
  band.wavelength = 1.0 / mean;
  band.direction = half_turn(0.5 * std::arg(sums.doubled));
  band.anisotropy = coherence;
  band.rms = rms;
  band.rms_sigma = 0.5 * rms / std::sqrt(independent);
  band.wavelength_sigma = std::sqrt(spread / independent) / (mean * mean);
  const double across = std::sqrt(std::max(1.0 - coherence * coherence, 0.0) / (2.0 * independent));
  band.direction_sigma = std::min(0.5 * across / std::max(coherence, 1e-6), pi / std::sqrt(12.0));
  return band;
}

// The numbers of the hills that hold most power.
std::vector<int> strongest(const Spectrum& spectrum, const Grid<int>& band, int count,
                           const BandOptions& options) {
  std::vector<double> power(static_cast<std::size_t>(count), 0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < band.size(); ++i) {
    total += spectrum.power[i];
    if (band[i] >= 0) power[std::size_t(band[i])] += spectrum.power[i];
  }
  std::vector<int> numbers;
  for (int number = 0; number < count; ++number) {
    if (power[std::size_t(number)] > options.least_share * total) numbers.push_back(number);
  }
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](int a, int b) { return power[std::size_t(a)] > power[std::size_t(b)]; });
  if (int(numbers.size()) > options.most) numbers.resize(std::size_t(options.most));
  return numbers;
}

// Waves of one length in all directions make a ring, which chance cuts into pieces that are broad
// in angle: these are one band. What has a direction is narrower.
void join_rings(Grid<int>& band, std::vector<int>& numbers, const Spectrum& spectrum) {
  std::vector<Sums> sums;
  for (const int number : numbers) {
    sums.push_back(sums_over(spectrum, [&](int row, int col) { return band(row, col) == number; }));
  }
  const auto is_broad = [](const Sums& one) {
    return std::abs(one.doubled) < broad_anisotropy * one.power;
  };
  const auto frequency = [](const Sums& one) { return one.frequency / one.power; };
  for (std::size_t a = 0; a < numbers.size(); ++a) {
    for (std::size_t b = a + 1; b < numbers.size();) {
      const double ratio = frequency(sums[a]) / frequency(sums[b]);
      if (std::abs(std::log(ratio)) < same_frequency && is_broad(sums[a]) && is_broad(sums[b])) {
        for (int& number : band) number = number == numbers[b] ? numbers[a] : number;
        numbers.erase(numbers.begin() + std::ptrdiff_t(b));
        sums.erase(sums.begin() + std::ptrdiff_t(b));
      } else {
        ++b;
      }
    }
  }
}

}  // namespace

std::vector<Band> bands(const Spectrum& spectrum, const Grid<float>& map, const Mask& mask,
                        const BandOptions& options) {
  auto [of_ordinates, count] = spectral_hills(spectrum);
  auto numbers = strongest(spectrum, of_ordinates, count, options);
  join_rings(of_ordinates, numbers, spectrum);
  const auto ordinates = ordinates_of(spectrum, of_ordinates);
  const auto shares = shares_of(ordinates, of_ordinates, numbers);
  const auto transform = transform_of(spectrum, map, mask);
  Mask trusted(spectrum.taper.rows(), spectrum.taper.cols(), 0);
  for (std::size_t i = 0; i < trusted.size(); ++i) trusted[i] = spectrum.taper[i] >= least_taper;
  std::vector<Band> result;
  for (const auto& share : shares) {
    const auto shared = share_map(ordinates, share, spectrum);
    const Sums sums = sums_over(
        spectrum, [&](int row, int col) { return col < shared.cols() ? shared(row, col) : 0.0f; });
    if (!(sums.power > 0.0)) continue;
    // An ordinate is exponentially distributed: its mean square is twice the square of its mean.
    const double independent = 2.0 * spectrum.independence * sums.power * sums.power / sums.squares;
    const auto waves = waves_of(transform, shared, spectrum.taper);
    const double rms = root_mean_square(waves, trusted);
    const double faster = root_mean_square(
        waves_of(transform, times_root_frequency(shared, spectrum), spectrum.taper), trusted);
    const auto alone = power_spectrum(waves, trusted, spectrum.extent, {.taper = light_taper});
    result.push_back(band_from(sums_over(alone, [](int, int) { return 1.0f; }), rms,
                               faster * faster / (rms * rms), independent));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Band& a, const Band& b) { return a.rms > b.rms; });
  return result;
}

}  // namespace hada
