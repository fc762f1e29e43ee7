#include "measure/hills.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hada {
namespace {

// Each pixel above the flood points towards the summit of its hill; a summit to itself.
class Flood {
 public:
  explicit Flood(std::size_t pixels) : towards_(pixels, nobody) {}

  bool emerged(std::size_t pixel) const { return towards_[pixel] != nobody; }
  void point(std::uint32_t pixel, std::uint32_t summit) { towards_[pixel] = summit; }
  std::uint32_t summit(std::uint32_t pixel) {
    while (towards_[pixel] != pixel) {
      towards_[pixel] = towards_[towards_[pixel]];
      pixel = towards_[pixel];
    }
    return pixel;
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  std::vector<std::uint32_t> towards_;
};

std::vector<std::uint32_t> from_the_highest(const Grid<float>& height, const Mask& mask) {
  std::vector<std::uint32_t> falling;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) falling.push_back(std::uint32_t(i));
  }
  std::stable_sort(falling.begin(), falling.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return height[a] > height[b]; });
  return falling;
}

}  // namespace

Hills hills(const Grid<float>& height, const Mask& mask, const HillOptions& options) {
  const auto falling = from_the_highest(height, mask);
  const int cols = height.cols();
  Flood flood(mask.size());
  for (const std::uint32_t pixel : falling) {
    flood.point(pixel, pixel);
    for (int d = 0; d < 9; ++d) {
      const int row = int(pixel) / cols + d / 3 - 1;
      int col = int(pixel) % cols + d % 3 - 1;
      if (options.columns_wrap) col = (col + cols) % cols;
      if (!mask.contains(row, col)) continue;
      const auto neighbour = std::uint32_t(row) * std::uint32_t(cols) + std::uint32_t(col);
      if (!flood.emerged(neighbour)) continue;
      const auto here = flood.summit(pixel), there = flood.summit(neighbour);
      if (here == there) continue;
      const auto low = height[here] > height[there] ? there : here;
      const auto high = low == here ? there : here;
      // Ground on the way down belongs to the first hill that it touches.
      if (low == pixel || height[low] - height[pixel] < options.least_rise(low))
        flood.point(low, high);
    }
  }
  Hills found{Grid<int>(mask.rows(), mask.cols(), -1), 0};
  for (const std::uint32_t pixel : falling) {
    const auto summit = flood.summit(pixel);
    if (summit == pixel)
      found.of_pixel[pixel] = found.count++;
    else
      found.of_pixel[pixel] = found.of_pixel[summit];
  }
  return found;
}

}  // namespace hada
