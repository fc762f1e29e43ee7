#include "fit/observe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/quantile.h"
#include "measure/measured_map.h"
#include "measure/response.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 32;   // along each side: fewer hold too few ordinates to tell shapes
constexpr double safe_reach = 0.6;  // share of Nyquist up to which aliases of anything are small
// Share of the highest power, of cells under the stronger taper: its leakage lies lower.
constexpr double faintest_steep = 1e-8;
constexpr double much_hidden = 0.05;  // share of the ordinates that leakage may hide

/// Taking off the mean empties frequency 0 alone. A plane takes 6 / pi^2 of the power one step away
/// with it; a quadratic nearly all of that, and some of it two steps away. A prior takes nothing.
double steps_emptied_by(const std::string& levelling) {
  if (levelling == "offset" || levelling == "prior") return 0.5;
  return levelling == "plane" ? 1.5 : 2.5;
}

/// Of patches that are as small as some ten thousand may be, so that they tell lines apart.
int patch_side(const Extent& extent) {
  constexpr double patches = 1e4;  // in the half plane
  return std::max(int(std::lround(std::sqrt(0.5 * extent.rows * extent.cols / patches))), 1);
}

// What is left of the power of a wave on the way from the surface to the map. Near Nyquist nothing
// is left that could be given back.
struct Losses {
  double pitch;
  bool photographed;
  double lens_blur_px;

  double power_left(double fx, double fy) const {
    constexpr double least = 0.1;
    double amplitude = photographed ? photographed_amplitude(fx, fy, pitch) : 1.0;
    if (lens_blur_px > 0.0) amplitude *= lens_amplitude(fx, fy, lens_blur_px * pitch);
    return std::max(amplitude * amplitude, least);
  }

  // Share of the Nyquist frequency up to which the lens leaves a third of the power: what it took
  // beyond is known too badly to be given back.
  double reach() const {
    if (lens_blur_px <= 0.0) return std::numbers::sqrt2;  // the corners
    return std::sqrt(std::log(3.0)) / (std::numbers::pi * lens_blur_px);
  }
};

void give_back(const Losses& losses, Spectrum& spectrum) {
  for (int row = 0; row < spectrum.power.rows(); ++row) {
    for (int col = 0; col < spectrum.power.cols(); ++col) {
      spectrum.power(row, col) /= losses.power_left(spectrum.fx(col), spectrum.fy(row));
    }
  }
}

double ordinates_of(const std::vector<Cell>& cells) {
  double sum = 0.0;
  for (const Cell& cell : cells) sum += cell.count;
  return sum;
}

/// How many ordinates the half plane holds up to a share of the Nyquist frequency.
double ordinates_within(double reach, const Spectrum& spectrum) {
  return 0.5 * std::numbers::pi * 0.25 * reach * reach * double(spectrum.power.size());
}

double mean_square(const Grid<float>& values, const Mask& mask) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) continue;
    sum += double(values[i]) * values[i];
    count += 1.0;
  }
  return sum / count;
}

// The variance of the slopes that shows as noise: what the fast waves hold, where the wrinkles have
// faded, but no more than the surface says of its normals (which counts the errors of the lights
// too, and those are no noise).
double slope_noise(const Surface& surface, const Losses& losses, const std::vector<Cell>& cells) {
  const double pitch = losses.pitch;
  const double fast = 0.7 * 0.5 / pitch;
  std::vector<double> variances;
  for (const Cell& cell : cells) {
    const double frequency = std::hypot(cell.fx, cell.fy);
    if (frequency < fast || frequency > 0.5 / pitch) continue;
    variances.push_back(cell.power * losses.power_left(cell.fx, cell.fy) /
                        integrated_noise(cell.fx, cell.fy, pitch));
  }
  const double told = mean_square(surface.normal_sigma, surface.mask);
  return variances.empty() ? 0.0 : std::min(median(std::move(variances)), told);
}

}  // namespace

Observation observe(const Surface& surface, double lens_blur_px) {
  Observation seen;
  if (!surface.has_height() && surface.albedo.empty()) {
    throw Error("wrinkle fit: the surface has neither height nor albedo; reconstruct it first");
  }
  if (!surface.has_height()) {
    seen.remarks.push_back(
        "The input has no height, so its brightness (0 to 1) was fitted: amplitudes are "
        "brightness, while lengths and angles keep their meaning.");
  }
  const auto map = measured_map(surface);
  seen.spectrum = power_spectrum(map, surface.mask, surface.extent);
  const bool photographed = surface.has_height() && !surface.normal_sigma.empty();
  const Losses losses{surface.extent.pitch, photographed, lens_blur_px};
  if (photographed || lens_blur_px > 0.0) give_back(losses, seen.spectrum);
  const Extent& box = seen.spectrum.extent;
  if (box.rows < fewest_pixels || box.cols < fewest_pixels) {
    throw Error("wrinkle fit: the mask is smaller than 32 x 32 pixels; measure a larger sample");
  }
  if (surface.extent.unit == Unit::px) {
    seen.remarks.push_back("The pitch is unknown: lengths and amplitudes count pixels, not mm.");
  }
  const Leakage leaked = leakage(seen.spectrum);
  seen.levelling = surface.levelling;
  const double hole = steps_emptied_by(surface.levelling);
  const double reach = losses.reach();
  seen.full = cells_of(
      seen.spectrum, leaked,
      {.empty_steps = hole, .reach = std::min(reach, 1.0), .most_leakage = 1.0, .faintest = 0.0});
  if (!surface.has_height()) {
    seen.whole =
        cells_of(seen.spectrum, leaked, {.empty_steps = hole, .reach = std::min(reach, 1.0)});
  }
  seen.square = cells_of(seen.spectrum, leaked,
                         {.empty_steps = hole,
                          .reach = reach,
                          .inner_bins = 8.0,
                          .patch = patch_side(box),
                          .most_leakage = 1.0,
                          .faintest = 0.0});
  const double safe = std::min(reach, safe_reach);
  const auto cut = [&](const Spectrum& spectrum, const Leakage& far, double faintest) {
    seen.fine = cells_of(spectrum, far, {.empty_steps = hole, .reach = safe, .faintest = faintest});
    seen.coarse = cells_of(
        spectrum, far,
        {.empty_steps = hole, .reach = safe, .inner_bins = 10.0, .growth = 0.12, .faintest = 1e-6});
  };
  cut(seen.spectrum, leaked, CellOptions().faintest);
  if (ordinates_of(seen.fine) < (1.0 - much_hidden) * ordinates_within(safe, seen.spectrum)) {
    seen.steep = power_spectrum(map, surface.mask, surface.extent, {.taper = 1.0});
    if (photographed || lens_blur_px > 0.0) give_back(losses, *seen.steep);
    cut(*seen.steep, leakage(*seen.steep), faintest_steep);
  }
  if (photographed) {
    const double variance = slope_noise(surface, losses, seen.full);
    for (auto* cells : {&seen.coarse, &seen.fine, &seen.full}) {
      for (Cell& cell : *cells) {
        cell.noise = variance * integrated_noise(cell.fx, cell.fy, losses.pitch) /
                     losses.power_left(cell.fx, cell.fy);
      }
    }
  }
  double highest = 0.0;
  for (const Cell& cell : seen.fine) highest = std::max(highest, cell.power);
  if (!(highest > 0.0)) {
    throw Error("wrinkle fit: the map is flat; there is nothing to fit");
  }
  // A cell that is empty to rounding has no logarithm.
  for (auto* cells : {&seen.coarse, &seen.fine, &seen.full, &seen.square}) {
    for (Cell& cell : *cells) cell.power = std::max(cell.power, 1e-25 * highest);
  }
  return seen;
}

}  // namespace hada
