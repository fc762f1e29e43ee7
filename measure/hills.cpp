#include "measure/hills.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hada {
namespace {

// Pixels that are joined by ground no lower than the flood; the root of each is its summit.
class Hills {
 public:
  explicit Hills(std::size_t pixels) : parent_(pixels, nobody) {}

  bool emerged(std::size_t pixel) const { return parent_[pixel] != nobody; }
  void emerge(std::uint32_t pixel) { parent_[pixel] = pixel; }
  std::uint32_t summit(std::uint32_t pixel) {
    while (parent_[pixel] != pixel) {
      parent_[pixel] = parent_[parent_[pixel]];
      pixel = parent_[pixel];
    }
    return pixel;
  }
  void join(std::uint32_t lower_summit, std::uint32_t higher_summit) {
    parent_[lower_summit] = higher_summit;
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  std::vector<std::uint32_t> parent_;
};

}  // namespace

int hill_count(const Grid<float>& height, const Mask& mask, double least_rise) {
  std::vector<std::uint32_t> falling;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) falling.push_back(std::uint32_t(i));
  }
  std::stable_sort(falling.begin(), falling.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return height[a] > height[b]; });
  Hills hills(mask.size());
  int count = 0;
  for (const std::uint32_t pixel : falling) {
    hills.emerge(pixel);
    ++count;
    const int row = int(pixel) / height.cols();
    const int col = int(pixel) % height.cols();
    for (int d = 0; d < 9; ++d) {
      const int r = row + d / 3 - 1;
      const int c = col + d % 3 - 1;
      if (!mask.contains(r, c)) continue;
      const auto neighbour = std::uint32_t(r) * std::uint32_t(height.cols()) + std::uint32_t(c);
      if (!hills.emerged(neighbour)) continue;
      auto low = hills.summit(pixel);
      auto high = hills.summit(neighbour);
      if (low == high) continue;
      if (height[low] > height[high]) std::swap(low, high);
      // A summit that rises this much above where it meets a higher one stays counted.
      if (height[low] - height[pixel] < least_rise || low == pixel) --count;
      hills.join(low, high);
    }
  }
  return count;
}

}  // namespace hada
