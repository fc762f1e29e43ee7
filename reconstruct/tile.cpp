#include "reconstruct/tile.h"

#include <algorithm>

namespace hada {

Tile::Tile(int light_count, int most_pixels, bool near_lights)
    : lights(light_count),
      pixels(most_pixels),
      stride((most_pixels + lane_count - 1) / lane_count * lane_count),
      near(near_lights),
      network(sorting_network(light_count)) {
  const std::size_t samples = std::size_t(lights) * std::size_t(stride);
  const std::size_t directions = near ? samples : std::size_t(lights);
  for (auto* values : {&grey, &trust, &weight}) values->assign(samples, 0.0f);
  if (near) closeness.assign(samples, 1.0f);
  for (auto* values : {&x_to, &y_to, &z_to}) values->assign(directions, 0.0f);
  for (auto* values : {&x, &y, &z}) values->assign(std::size_t(stride), 0.0f);
  scratch.assign(2 * std::size_t(lights) * lane_count, 0.0f);
}

std::vector<std::pair<int, int>> sorting_network(int count) {
  std::vector<std::pair<int, int>> steps;
  for (int p = 1; p < count; p *= 2) {
    for (int k = p; k >= 1; k /= 2) {
      for (int j = k % p; j + k < count; j += 2 * k) {
        for (int i = 0; i < std::min(k, count - j - k); ++i) {
          if ((i + j) / (2 * p) == (i + j + k) / (2 * p)) steps.emplace_back(i + j, i + j + k);
        }
      }
    }
  }
  return steps;
}

}  // namespace hada
