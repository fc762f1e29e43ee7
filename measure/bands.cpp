#include "measure/bands.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/bounding_box.h"
#include "core/fft.h"
#include "core/field.h"
#include "core/parallel.h"
#include "measure/hump_search.h"
#include "measure/waves_apart.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_taper = 0.3;  // where what was tapered can be given back

/// What the waves of a band are like on the whole.
struct Centroid {
  double frequency = 0.0;              // mean over the power
  double spread = 0.0;                 // standard deviation about it
  std::complex<double> doubled = 0.0;  // mean of exp(2 i direction)
};

// share  of the power that counts, at every ordinate of half a plane
template <class Share>
Centroid centroid_of(const Spectrum& spectrum, const Share& share) {
  double power = 0.0, frequency = 0.0, squares = 0.0;
  std::complex<double> doubled = 0.0;
  const int cols = spectrum.power.cols(), half = cols / 2 + 1;
  for (int row = 0; row < spectrum.power.rows(); ++row) {
    for (int col = row == 0 ? 1 : 0; col < half; ++col) {
      const double times = col == 0 || 2 * col == cols ? 1.0 : 2.0;  // of the whole plane
      const double here = times * share(row, col) * spectrum.power(row, col);
      if (!(here > 0.0)) continue;
      const double fx = spectrum.fx(col), fy = spectrum.fy(row), ff = fx * fx + fy * fy;
      power += here;
      frequency += here * std::sqrt(ff);
      squares += here * ff;
      doubled += here * std::complex<double>(fx * fx - fy * fy, 2.0 * fx * fy) / ff;
    }
  }
  const double mean = frequency / power;
  return {mean, std::sqrt(std::max(squares / power - mean * mean, 0.0)), doubled / power};
}

// The waves of one band alone: filtered out of the tapered map, the taper taken off again where it
// is not too thin.
Grid<float> waves_of(const Grid<std::complex<double>>& transform, const Grid<float>& share,
                     const Grid<double>& taper) {
  auto part = transform;
  for (int row = 0; row < part.rows(); ++row) {
    for (int col = 0; col < part.cols(); ++col) part(row, col) *= double(share(row, col));
  }
  const auto tapered = inverse_fft(std::move(part), taper.cols());
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

// density(fx, fy) at every frequency of half a plane but 0.
template <class Density>
Grid<float> half_plane(const Spectrum& spectrum, const Density& density) {
  Grid<float> values(spectrum.power.rows(), spectrum.power.cols() / 2 + 1);
  for_each_index(values.rows(), [&](int row) {
    for (int col = row == 0 ? 1 : 0; col < values.cols(); ++col)
      values(row, col) = float(density(spectrum.fx(col), spectrum.fy(row)));
  });
  return values;
}

Grid<float> densities_of(const HumpMixture& mixture, const Spectrum& spectrum) {
  return half_plane(spectrum, [&](double fx, double fy) { return mixture.density(fx, fy); });
}

// The share of the power that is the hump's.
//
// densities  of the mixture that it is in
Grid<float> share_of(const SpectralHump& hump, const Grid<float>& densities,
                     const Spectrum& spectrum) {
  auto share = half_plane(spectrum, [&](double fx, double fy) { return hump.density(fx, fy); });
  for (std::size_t i = 1; i < share.size(); ++i) share[i] /= densities[i];
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

// independent  how many independent observations the band rests on
Band band_from(const Centroid& centroid, double rms, double independent) {
  Band band;
  const double coherence = std::min(std::abs(centroid.doubled), 1.0);
  band.wavelength = 1.0 / centroid.frequency;
  band.direction = half_turn(0.5 * std::arg(centroid.doubled));
  band.anisotropy = coherence;
  band.rms = rms;
  band.rms_sigma = 0.5 * rms / std::sqrt(independent);
  band.wavelength_sigma =
      centroid.spread / std::sqrt(independent) * band.wavelength * band.wavelength;
  const double across = std::sqrt(std::max(1.0 - coherence * coherence, 0.0) / (2.0 * independent));
  band.direction_sigma = std::min(0.5 * across / std::max(coherence, 1e-6), pi / std::sqrt(12.0));
  return band;
}

// The spectrum of what lies in the largest rectangle inside the mask, tapered up to its middle:
// strong waves leak least into weak ones so. An irregular border would not let a taper be smooth.
Spectrum inner_spectrum(const Grid<float>& map, const Mask& mask, const Extent& extent) {
  constexpr int least_side = 8;  // for a spectrum
  PixelBox box = largest_box_inside(mask);
  if (std::min(box.rows, box.cols) < least_side) box = bounding_box(mask);  // holes all over
  return power_spectrum(crop(map, box.row, box.col, box.rows, box.cols),
                        crop(mask, box.row, box.col, box.rows, box.cols),
                        {box.rows, box.cols, extent.pitch, extent.unit}, {.taper = 1.0});
}

// How many independent waves a hump is made of, on that map: its variance is a sum of so many
// squares, each exponentially distributed.
double independent_waves(const SpectralHump& hump, const std::vector<SpectralPatch>& patches,
                         double independence) {
  double sum = 0.0, squares = 0.0;
  for (const SpectralPatch& patch : patches) {
    const double density = hump.density(patch.fx, patch.fy);
    sum += patch.count * density;
    squares += patch.count * density * density;
  }
  return std::max(1.0, independence * sum * sum / squares);  // 1 also of one beyond all patches
}

}  // namespace

std::vector<Band> bands(const Spectrum& spectrum, const Grid<float>& map, const Mask& mask,
                        const BandOptions& options) {
  const Extent extent{map.rows(), map.cols(), spectrum.extent.pitch, spectrum.extent.unit};
  const Spectrum inner = inner_spectrum(map, mask, extent);
  const HumpMixture mixture = humps_of(inner, options.most);
  const auto patches = patches_of(inner);
  const auto apart = waves_apart(map, mask, extent, mixture);
  const Spectrum inner_rest = inner_spectrum(apart.rest, mask, extent);
  const auto transform = transform_of(spectrum, apart.rest, mask);
  const auto densities = densities_of(mixture, spectrum);
  const auto inner_densities = densities_of(mixture, inner_rest);
  Mask trusted(spectrum.taper.rows(), spectrum.taper.cols(), 0);
  for (std::size_t i = 0; i < trusted.size(); ++i) trusted[i] = spectrum.taper[i] >= least_taper;
  double total = 0.0;
  for (const double power : spectrum.power) total += power;
  total /= spectrum.extent.width() * spectrum.extent.height();
  std::vector<Band> result;
  for (std::size_t k = 0; k < mixture.humps.size(); ++k) {
    const SpectralHump& hump = mixture.humps[k];
    const double independent = independent_waves(hump, patches, inner.independence);
    Band band;
    if (const auto& waves = apart.of_hump[k]) {
      auto centroid = centroid_of(inner_spectrum(waves->map, apart.mask, apart.extent),
                                  [](int, int) { return 1.0; });
      centroid.frequency *= waves->frequency_ratio;
      band = band_from(centroid, std::sqrt(waves->mean_square), independent);
    } else {
      auto amplitude = share_of(hump, densities, spectrum);
      for (float& value : amplitude) value = std::sqrt(value);
      const auto filtered = waves_of(transform, amplitude, spectrum.taper);
      const auto share = share_of(hump, inner_densities, inner_rest);
      const auto centroid =
          centroid_of(inner_rest, [&](int row, int col) { return double(share(row, col)); });
      band = band_from(centroid, root_mean_square(filtered, trusted), independent);
    }
    if (band.rms * band.rms > options.least_share * total) result.push_back(band);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Band& a, const Band& b) { return a.rms > b.rms; });
  return result;
}

}  // namespace hada
