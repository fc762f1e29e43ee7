#include "bench/made_stems.h"

#include <algorithm>
#include <cmath>

#include "synth/synthesize.h"

namespace hada {

Wood<> made_stem(Seed seed) {
  Wood<> wood;
  const auto luck = [&](int k, double low, double high) {
    return low + (high - low) * uniform(seed, k);
  };
  wood.pith_mm = {luck(0, -12.0, 12.0), luck(1, -12.0, 12.0)};
  if (seed % 3 == 0) wood.pith_mm[0] -= 45.0;  // every third lies outside
  wood.lobes = {{2.0, luck(2, -0.04, 0.04), luck(3, -0.04, 0.04)},
                {3.0, luck(4, -0.015, 0.015), luck(5, -0.015, 0.015)}};
  wood.latewood_share = luck(6, 0.25, 0.55);
  wood.fibre_shift = luck(7, 0.05, 0.2);
  wood.fibre_mm = 0.15;
  wood.ring_radii_mm.clear();
  double log_width = std::log(2.2), radius = 0.0;
  for (int k = 0; radius < 110.0; ++k) {
    log_width = std::log(2.2) + 0.65 * (log_width - std::log(2.2)) + 0.22 * gaussian(seed, k, 1);
    radius += std::max(std::exp(log_width), 0.9);
    wood.ring_radii_mm.push_back(radius);
  }
  return wood;
}

Surface picture_of(const Wood<>& wood, const Extent& extent, Seed seed, int finer) {
  Extent fine = extent;
  fine.rows *= finer;
  fine.cols *= finer;
  fine.pitch /= finer;
  const auto drawn = synthesize(wood, fine, seed).albedo;
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.albedo = Image(extent.rows, extent.cols, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (int row = 0; row < extent.rows; ++row) {
      for (int col = 0; col < extent.cols; ++col) {
        double sum = 0.0;
        for (int k = 0; k < finer * finer; ++k)
          sum += double(drawn.planes[c](finer * row + k / finer, finer * col + k % finer));
        const double seen = sum / (finer * finer) + 0.01 * gaussian(seed + 7, row, col, int(c));
        surface.albedo.planes[c](row, col) =
            float(std::round(255.0 * std::clamp(seen, 0.0, 1.0)) / 255.0);
      }
    }
  }
  return surface;
}

}  // namespace hada
