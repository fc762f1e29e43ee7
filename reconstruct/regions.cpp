#include "reconstruct/regions.h"

#include <utility>

namespace hada {

Regions regions_of(const Mask& mask) {
  Regions regions{Grid<int>(mask.rows(), mask.cols(), 0), {0}};
  std::vector<std::pair<int, int>> open;  // reached, but not yet left
  const auto reach = [&](int row, int col) {
    if (!mask.contains(row, col) || !mask(row, col) || regions.label(row, col)) return;
    regions.label(row, col) = int(regions.size.size()) - 1;
    ++regions.size.back();
    open.emplace_back(row, col);
  };
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) ++regions.size[0];
      if (!mask(row, col) || regions.label(row, col)) continue;
      regions.size.push_back(0);
      reach(row, col);
      while (!open.empty()) {
        const auto [r, c] = open.back();
        open.pop_back();
        reach(r, c + 1);
        reach(r, c - 1);
        reach(r + 1, c);
        reach(r - 1, c);
      }
    }
  }
  return regions;
}

}  // namespace hada
