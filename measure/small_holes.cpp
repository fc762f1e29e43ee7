#include "measure/small_holes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hada {
namespace {

constexpr float settled = 1e-3f;  // of the range of heights round a hole: the last sweep moved less

// The pixels of the hole at `start`; `seen` learns them all.
std::vector<std::size_t> hole_at(std::size_t start, const Mask& mask, Mask& seen, bool& at_side) {
  std::vector<std::size_t> hole{start};
  seen[start] = 1;
  at_side = false;
  for (std::size_t next = 0; next < hole.size(); ++next) {
    const int row = int(hole[next] / std::size_t(mask.cols()));
    const int col = int(hole[next] % std::size_t(mask.cols()));
    for (const auto& [r, c] : std::array<std::array<int, 2>, 4>{
             {{row - 1, col}, {row + 1, col}, {row, col - 1}, {row, col + 1}}}) {
      if (!mask.contains(r, c)) {
        at_side = true;
        continue;
      }
      const std::size_t other = std::size_t(r) * std::size_t(mask.cols()) + std::size_t(c);
      if (mask[other] || seen[other]) continue;
      seen[other] = 1;
      hole.push_back(other);
    }
  }
  return hole;
}

// Gauss-Seidel from the mean of what lies around. Wide holes settle slowly: one of 20 x 20 is left
// within 2 % of the range round it.
void fill(Grid<float>& map, const Mask& mask, const std::vector<std::size_t>& hole) {
  const auto cols = std::size_t(map.cols());
  double sum = 0.0, count = 0.0;
  float least = HUGE_VALF, most = -HUGE_VALF;
  for (const std::size_t pixel : hole) {
    for (const std::size_t other : {pixel - cols, pixel - 1, pixel + 1, pixel + cols}) {
      if (!mask[other]) continue;
      sum += map[other];
      count += 1.0;
      least = std::min(least, map[other]);
      most = std::max(most, map[other]);
    }
  }
  for (const std::size_t pixel : hole) map[pixel] = float(sum / count);
  const std::size_t sweeps = 4 * hole.size();
  float moved = HUGE_VALF;
  for (std::size_t sweep = 0; sweep < sweeps && moved > settled * (most - least); ++sweep) {
    moved = 0.0f;
    for (const std::size_t pixel : hole) {
      const float mean =
          0.25f * ((map[pixel - cols] + map[pixel + cols]) + (map[pixel - 1] + map[pixel + 1]));
      moved = std::max(moved, std::abs(mean - map[pixel]));
      map[pixel] = mean;
    }
  }
}

}  // namespace

std::optional<MaskedMap> without_small_holes(const Grid<float>& map, const Mask& mask,
                                             int most_pixels) {
  assert(map.same_size(mask));
  std::optional<MaskedMap> filled;
  Mask seen(mask.rows(), mask.cols(), 0);
  for (std::size_t pixel = 0; pixel < mask.size(); ++pixel) {
    if (mask[pixel] || seen[pixel]) continue;
    bool at_side = false;
    auto hole = hole_at(pixel, mask, seen, at_side);
    if (at_side || hole.size() > std::size_t(most_pixels)) continue;
    std::sort(hole.begin(), hole.end());  // swept as the rows lie
    if (!filled) filled = {map, mask};
    fill(filled->map, mask, hole);
    for (const std::size_t inside : hole) filled->mask[inside] = 1;
  }
  return filled;
}

}  // namespace hada
