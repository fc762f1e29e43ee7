#include "app/draw/spectrum_picture.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "measure/polar.h"

namespace hada {

SpectrumStyle spectrum_style(const Spectrum& spectrum) {
  const Rings by_ring = rings(spectrum);
  double total = 0.0;
  for (const double power : by_ring.power) total += power;
  double so_far = 0.0;
  SpectrumStyle style;
  const double nyquist = 0.5 / spectrum.extent.pitch;
  style.highest_frequency = nyquist;
  for (std::size_t i = 0; i < by_ring.power.size(); ++i) {
    so_far += by_ring.power[i];
    if (so_far < 0.999 * total) continue;
    style.highest_frequency = std::clamp(1.5 * by_ring.frequency[i], 0.1 * nyquist, nyquist);
    break;
  }
  double top = 0.0;
  for (const double power : spectrum.power) top = std::max(top, power);
  constexpr double decades = 6.0;
  const double high = std::log10(std::max(top, 1e-300));
  style.log_power = {high - decades, high};
  return style;
}

Image spectrum_picture(const Spectrum& spectrum, const SpectrumStyle& style, int side_px) {
  const int rows = spectrum.power.rows();
  const int cols = spectrum.power.cols();
  const double step = 2.0 * style.highest_frequency / side_px;  // cycles per unit and pixel
  // Ordinates from one border of a picture pixel to the other, at least the nearest one.
  const auto indices = [&](int pixel, double length) {
    const double from = (pixel - 0.5 * side_px) * step * length;
    const int first = int(std::ceil(from));
    const int last = int(std::ceil(from + step * length)) - 1;
    const int nearest = int(std::lround(from + 0.5 * step * length));
    return last >= first ? std::pair(first, last) : std::pair(nearest, nearest);
  };
  const auto wrapped_index = [](int k, int n) { return ((k % n) + n) % n; };
  Grid<float> log_power(side_px, side_px);
  for_each_index(side_px, [&](int row) {
    const auto [j0, j1] = indices(side_px - 1 - row, spectrum.extent.height());
    for (int col = 0; col < side_px; ++col) {
      const auto [i0, i1] = indices(col, spectrum.extent.width());
      double sum = 0.0;
      for (int j = j0; j <= j1; ++j) {
        // Rows of the transform count frequencies that run downward.
        const int source_row = wrapped_index(-j, rows);
        for (int i = i0; i <= i1; ++i) sum += spectrum.power(source_row, wrapped_index(i, cols));
      }
      const double mean = sum / (double(j1 - j0 + 1) * double(i1 - i0 + 1));
      log_power(row, col) = float(std::log10(std::max(mean, 1e-300)));
    }
  });
  return scalar_picture(log_power, Mask(side_px, side_px, 1), style.log_power);
}

}  // namespace hada
