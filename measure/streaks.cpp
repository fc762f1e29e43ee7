#include "measure/streaks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/quantile.h"
#include "measure/line_field.h"

namespace hada {
namespace {

constexpr std::array lags = {6, 12, 18, 24};      // rows
constexpr double fine_px = 0.6, coarse_px = 2.0;  // Gaussians whose difference is the texture
constexpr double line_px = 3.0;                   // Gaussian that leaves the stronger lines
constexpr double strong_line = 1.8;               // times the usual slope of that
constexpr float most = 2.5f;                      // deviations that one pixel may count
constexpr double least_filled = 0.3;              // of the pixels of a part

/// The texture in deviations, and where it counts.
struct Texture {
  Grid<float> values;
  Mask counts;
};

Texture texture_of(const Grid<float>& map, const Mask& mask) {
  Texture texture{smoothed(map, mask, fine_px), mask};
  const auto coarse = smoothed(map, mask, coarse_px);
  std::vector<float> sizes;
  for (std::size_t i = 0; i < map.size(); ++i) {
    texture.values[i] -= coarse[i];
    if (mask[i] && i % 7 == 0) sizes.push_back(std::abs(texture.values[i]));
  }
  const float deviation = sizes.empty() ? 0.0f : 1.4826f * median(sizes);
  if (!(deviation > 0.0f)) return {texture.values, Mask(map.rows(), map.cols(), 0)};
  for (float& value : texture.values) value = std::clamp(value / deviation, -most, most);
  const auto lines = line_field(map, mask, {.gradient_px = line_px, .window_px = 1.5});
  const auto strength_at = [&](std::size_t i) {
    return lines.strength(int(i) / map.cols(), int(i) % map.cols());
  };
  std::vector<float> strengths;
  for (std::size_t i = 0; i < map.size(); i += 7) {
    if (strength_at(i) > 0.0f) strengths.push_back(strength_at(i));
  }
  const float strong = strengths.empty() ? 0.0f : float(strong_line) * median(strengths);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!(strength_at(i) > 0.0f) || strength_at(i) > strong) texture.counts[i] = 0;
  }
  return texture;
}

/// Correlation of a part with what lies `lag` rows above, at every shift from -reach to reach.
std::vector<double> likeness_at(const Texture& texture, int row, int col,
                                const StreakOptions& options, int lag, int reach) {
  const int rows = texture.values.rows(), cols = texture.values.cols();
  std::vector<double> product(std::size_t(2 * reach + 1), 0.0), count = product;
  double square = 0.0, pixels = 0.0;
  for (int r = std::max(row, lag); r < std::min(row + options.tile_rows, rows); ++r) {
    for (int c = col; c < std::min(col + options.tile_cols, cols); ++c) {
      if (!texture.counts(r, c)) continue;
      const float value = texture.values(r, c);
      square += double(value) * double(value);
      pixels += 1.0;
      const int first = std::max(-reach, -c), last = std::min(reach, cols - 1 - c);
      for (int shift = first; shift <= last; ++shift) {
        if (!texture.counts(r - lag, c + shift)) continue;
        product[std::size_t(shift + reach)] += double(value * texture.values(r - lag, c + shift));
        count[std::size_t(shift + reach)] += 1.0;
      }
    }
  }
  const double least = least_filled * options.tile_rows * options.tile_cols;
  for (std::size_t k = 0; k < product.size(); ++k) {
    product[k] =
        count[k] > 0.5 * least && pixels > least ? product[k] / count[k] * pixels / square : 0.0;
  }
  return product;
}

Streak streak_of(const Texture& texture, int row, int col, const Extent& extent,
                 const StreakOptions& options) {
  std::array<std::vector<double>, lags.size()> likeness;
  std::array<int, lags.size()> reach{};
  for (std::size_t k = 0; k < lags.size(); ++k) {
    reach[k] = int(std::ceil(options.steepest * lags[k])) + 1;
    likeness[k] = likeness_at(texture, row, col, options, lags[k], reach[k]);
  }
  const auto mean_at = [&](double slope) {
    double sum = 0.0;
    for (std::size_t k = 0; k < lags.size(); ++k) {
      const double at = slope * lags[k] + reach[k];
      const auto i = std::size_t(at);
      const double t = at - double(i);
      sum += (1.0 - t) * likeness[k][i] + t * likeness[k][i + 1];
    }
    return sum / double(lags.size());
  };
  const double step = 0.25 / lags.back();
  double best = 0.0, highest = -1.0;
  for (double slope = -options.steepest; slope <= options.steepest; slope += step) {
    const double here = mean_at(slope);
    if (here <= highest) continue;
    highest = here;
    best = slope;
  }
  // A parabola over the width of the peak: half a pixel at the longest lag to either side.
  const double wide = 0.75 / lags.back();
  const double before = mean_at(std::max(best - wide, -options.steepest));
  const double after = mean_at(std::min(best + wide, options.steepest));
  const double curvature = before - 2.0 * highest + after;
  if (curvature < 0.0) best += std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) * wide;
  // Peaks are sharpest at the long lags: on the whole, rows 18 apart are compared.
  const double middle_row = row + 0.5 * (options.tile_rows - 1) - 9.0;
  return {extent.place(middle_row, col + 0.5 * (options.tile_cols - 1)), best, highest};
}

}  // namespace

std::vector<Streak> streaks(const Grid<float>& map, const Mask& mask, const Extent& extent,
                            const StreakOptions& options) {
  const Texture texture = texture_of(map, mask);
  const int down = std::max(1, (map.rows() - lags.back()) / options.tile_rows);
  const int across = std::max(1, map.cols() / options.tile_cols);
  std::vector<Streak> all(std::size_t(down * across));
  for_each_index(down * across, [&](int k) {
    const int row = lags.back() + k / across * options.tile_rows;
    const int col = k % across * options.tile_cols;
    all[std::size_t(k)] = streak_of(texture, row, col, extent, options);
  });
  // At the steepest slope that was tried nothing has been found, only the search has ended.
  std::erase_if(all, [&](const Streak& one) {
    return one.likeness < options.least_likeness || std::abs(one.slope) > 0.97 * options.steepest;
  });
  return all;
}

}  // namespace hada
