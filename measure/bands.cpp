#include "measure/bands.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/bounding_box.h"
#include "core/fft.h"
#include "core/field.h"
#include "core/parallel.h"
#include "measure/half_plane.h"
#include "measure/hump_search.h"
#include "measure/small_holes.h"
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

// Of the ordinates of `spectrum` up to those frequencies.
//
// share(fx, fy)  of the power that counts
template <class Share>
Centroid centroid_of(const Spectrum& spectrum, double most_fx, double most_fy, const Share& share) {
  double power = 0.0, frequency = 0.0, squares = 0.0;
  std::complex<double> doubled = 0.0;
  visit_half_plane(spectrum, most_fx, most_fy,
                   [&](int row, int col, double fx, double fy, int times) {
                     const double here = times * share(fx, fy) * spectrum.power(row, col);
                     if (!(here > 0.0)) return;
                     const double ff = fx * fx + fy * fy;
                     power += here;
                     frequency += here * std::sqrt(ff);
                     squares += here * ff;
                     doubled += here * std::complex<double>(fx * fx - fy * fy, 2.0 * fx * fy) / ff;
                   });
  const double mean = frequency / power;
  return {mean, std::sqrt(std::max(squares / power - mean * mean, 0.0)), doubled / power};
}

/// The share of a hump in the density of its mixture, by frequency.
class Share {
 public:
  Share(const SpectralHump& hump, const HumpMixture& mixture) : hump_(hump), all_(mixture) {}
  double operator()(double fx, double fy) const { return hump_(fx, fy) / all_(fx, fy); }

  double most_fx() const { return hump_.reach(0, reach); }
  double most_fy() const { return hump_.reach(1, reach); }

 private:
  static constexpr double reach = 5.0;  // widths: beyond lie 4e-6 of the power
  HumpDensity hump_;
  MixtureDensity all_;
};

// Mean square of the waves of one band: filtered out of the tapered map, the taper taken off again
// where it is not too thin. The waves are worked out in steps as wide as they allow.
double mean_square(const Grid<std::complex<double>>& transform, const Share& share,
                   const Spectrum& spectrum) {
  const auto& taper = spectrum.taper;
  const int rows = taper.rows(), cols = taper.cols();
  const auto steps = [](double most_f, double length, int count) {
    return int(std::min(std::floor(most_f * length), double((count - 1) / 2)));
  };
  const int most_row = steps(share.most_fy(), spectrum.extent.height(), rows);
  const int most_col = steps(share.most_fx(), spectrum.extent.width(), cols);
  // So many at least that some lie where the taper is not too thin.
  constexpr int fewest = 16;
  const int fewer_rows = std::min(rows, fast_length(std::max(2 * most_row + 1, fewest)));
  const int fewer_cols = std::min(cols, fast_length(std::max(2 * most_col + 1, fewest)));
  Grid<std::complex<double>> part(fewer_rows, fewer_cols / 2 + 1);
  const double scale = double(fewer_rows) * fewer_cols / (double(rows) * cols);
  for_each_index(2 * most_row + 1, [&](int i) {
    const int row = (i - most_row + rows) % rows;
    const int fewer_row = (i - most_row + fewer_rows) % fewer_rows;
    for (int col = row == 0 ? 1 : 0; col <= most_col; ++col)
      part(fewer_row, col) =
          scale * std::sqrt(share(spectrum.fx(col), spectrum.fy(row))) * transform(row, col);
  });
  const auto waves = inverse_fft(std::move(part), fewer_cols);
  double sum = 0.0, count = 0.0;
  for (int row = 0; row < fewer_rows; ++row) {
    const int taper_row = int(std::int64_t(row) * rows / fewer_rows);
    for (int col = 0; col < fewer_cols; ++col) {
      const double weight = taper(taper_row, int(std::int64_t(col) * cols / fewer_cols));
      if (!(weight >= least_taper)) continue;
      sum += std::pow(waves(row, col) / weight, 2);
      count += 1.0;
    }
  }
  return sum / count;
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

// What lies in the largest rectangle inside the mask, if it has a spectrum: an irregular border
// would not let a taper be smooth.
PixelBox inner_box(const Mask& mask) {
  const PixelBox box = largest_box_inside(mask);
  return std::min(box.rows, box.cols) < fewest_spectrum_pixels ? bounding_box(mask) : box;
}

// Its spectrum, tapered up to its middle: strong waves leak least into weak ones so.
Spectrum inner_spectrum(const Grid<float>& map, const Mask& mask, const Extent& extent) {
  const PixelBox box = inner_box(mask);
  return power_spectrum(crop(map, box.row, box.col, box.rows, box.cols),
                        crop(mask, box.row, box.col, box.rows, box.cols),
                        {box.rows, box.cols, extent.pitch, extent.unit}, {.taper = 1.0});
}

// How many independent waves a hump is made of, on that map: its variance is a sum of so many
// squares, each exponentially distributed.
double independent_waves(const SpectralHump& hump, const SpectralPatches& patches) {
  const HumpDensity density_at(hump);
  double sum = 0.0, squares = 0.0;
  for (const SpectralPatch& patch : patches.all) {
    const double density = density_at(patch.fx, patch.fy);
    sum += patch.count * density;
    squares += patch.count * density * density;
  }
  // 1 also of one beyond all patches
  return std::max(1.0, patches.independence * sum * sum / squares);
}

/// What of a map was not told apart without a taper.
struct Rest {
  Grid<std::complex<double>> transform;  // with the taper of the spectrum of the map
  Spectrum inner;
};

// Whether the map is anything but the rounding of its values.
bool is_rough(const Grid<float>& map, const Mask& mask, double variance) {
  double largest = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (mask[i]) largest = std::max(largest, double(std::abs(map[i])));
  }
  return variance > std::pow(std::numeric_limits<float>::epsilon() * largest, 2);
}

}  // namespace

std::vector<Band> bands(const Spectrum& spectrum, const Grid<float>& torn_map,
                        const Mask& torn_mask, const BandOptions& options) {
  const auto filled = without_small_holes(torn_map, torn_mask);
  const Grid<float>& map = filled ? filled->map : torn_map;
  const Mask& mask = filled ? filled->mask : torn_mask;
  const Extent extent{map.rows(), map.cols(), spectrum.extent.pitch, spectrum.extent.unit};
  double total = 0.0;
  for (const double power : spectrum.power) total += power;
  total /= spectrum.extent.width() * spectrum.extent.height();
  if (!is_rough(map, mask, total)) return {};
  const auto patches = patches_of(inner_spectrum(map, mask, extent));
  const HumpMixture mixture = without_flanks(humps_of(patches, options.most), patches.all);
  const auto apart = waves_apart(map, mask, extent, mixture);
  std::optional<Rest> rest;
  if (!std::all_of(apart.of_hump.begin(), apart.of_hump.end(),
                   [](const auto& waves) { return waves.has_value(); }))
    rest = {fft(tapered(apart.rest, bounding_box(mask), spectrum.taper)),
            inner_spectrum(apart.rest, mask, extent)};
  std::vector<Band> result;
  for (std::size_t k = 0; k < mixture.humps.size(); ++k) {
    const SpectralHump& hump = mixture.humps[k];
    const double independent = independent_waves(hump, patches);
    Band band;
    if (const auto& waves = apart.of_hump[k]) {
      auto centroid = centroid_of(inner_spectrum(waves->map, apart.mask, apart.extent), HUGE_VAL,
                                  HUGE_VAL, [](double, double) { return 1.0; });
      centroid.frequency *= waves->frequency_ratio;
      band = band_from(centroid, std::sqrt(waves->mean_square), independent);
    } else {
      const Share share(hump, mixture);
      const auto centroid = centroid_of(rest->inner, share.most_fx(), share.most_fy(), share);
      const double rms = std::sqrt(mean_square(rest->transform, share, spectrum));
      band = band_from(centroid, rms, independent);
    }
    if (band.rms * band.rms > options.least_share * total) result.push_back(band);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Band& a, const Band& b) { return a.rms > b.rms; });
  return result;
}

}  // namespace hada
