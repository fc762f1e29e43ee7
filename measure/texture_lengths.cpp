#include "measure/texture_lengths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/parallel.h"
#include "measure/autocorrelation.h"
#include "measure/blocks.h"
#include "measure/jackknife.h"

namespace hada {
namespace {

constexpr int directions = 180;  // in half a turn
constexpr int resampled_directions = 36;
constexpr int most_resampled_px = 512;  // along each side
constexpr double resampled_length_px = 4.0;

TextureLengths lengths(const Grid<float>& height, const Mask& mask, int count) {
  const auto all = Autocorrelation(height, mask).lengths_px(count);
  const auto [shortest, longest] = std::minmax_element(all.begin(), all.end());
  return {*shortest, *longest > 0.0 ? *shortest / *longest : 0.0};
}

/// A map in which nothing is finer than its correlation asks for, no larger than is affordable.
struct Resampled {
  Grid<float> height;
  Mask mask;
  double area_share = 1.0;  // of the pixels of the original
};

Resampled resampled(const Grid<float>& height, const Mask& mask, double length_px) {
  const int bin = std::max(1, int(length_px / resampled_length_px));
  const int rows = std::min(height.rows() / bin, most_resampled_px);
  const int cols = std::min(height.cols() / bin, most_resampled_px);
  const int first_row = (height.rows() - rows * bin) / 2;
  const int first_col = (height.cols() - cols * bin) / 2;
  Resampled result{Grid<float>(rows, cols), Mask(rows, cols, 0)};
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      double sum = 0.0;
      int count = 0;
      for (int i = 0; i < bin * bin; ++i) {
        const int r = first_row + row * bin + i / bin;
        const int c = first_col + col * bin + i % bin;
        if (!mask(r, c)) continue;
        sum += height(r, c);
        ++count;
      }
      if (2 * count < bin * bin) continue;
      result.mask(row, col) = 1;
      result.height(row, col) = float(sum / count);
    }
  }
  result.area_share = double(rows) * cols * bin * bin / double(height.size());
  return result;
}

bool is_flat(const Grid<float>& height, const Mask& mask) {
  const float* first = nullptr;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    if (first && height[i] != *first) return false;
    first = &height[i];
  }
  return true;
}

Mask without_block(Mask mask, int block) {
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (block_at(mask, row, col) == block) mask(row, col) = 0;
    }
  }
  return mask;
}

}  // namespace

TextureLengths texture_lengths(const Grid<float>& height, const Mask& mask) {
  return lengths(height, mask, directions);
}

TextureLengths texture_lengths_sigma(const TextureLengths& found, const Grid<float>& height,
                                     const Mask& mask) {
  const auto small = resampled(height, mask, found.shortest_px);
  std::vector<double> count(block_count, 0.0);
  double total = 0.0;
  for (int row = 0; row < small.mask.rows(); ++row) {
    for (int col = 0; col < small.mask.cols(); ++col) {
      if (!small.mask(row, col)) continue;
      count[std::size_t(block_at(small.mask, row, col))] += 1.0;
      total += 1.0;
    }
  }
  if (is_flat(small.height, small.mask)) return {};
  const auto whole = lengths(small.height, small.mask, resampled_directions);
  std::vector<std::optional<TextureLengths>> without(block_count);
  for_each_index(block_count, [&](int block) {
    if (!counts_as_block(count[std::size_t(block)], total)) return;
    const Mask rest = without_block(small.mask, block);
    if (!is_flat(small.height, rest)) {
      without[std::size_t(block)] = lengths(small.height, rest, resampled_directions);
    }
  });
  std::vector<LeftOut> shortest, aspect;
  for (int block = 0; block < block_count; ++block) {
    const auto& one = without[std::size_t(block)];
    if (!one) continue;
    const double ratio = total / count[std::size_t(block)];
    shortest.push_back({one->shortest_px, ratio});
    aspect.push_back({one->aspect, ratio});
  }
  const double larger = std::sqrt(small.area_share);
  return {
      found.shortest_px * larger * jackknife_sigma(whole.shortest_px, shortest) / whole.shortest_px,
      larger * jackknife_sigma(whole.aspect, aspect)};
}

}  // namespace hada
