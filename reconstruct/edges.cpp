#include "reconstruct/edges.h"

#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {

Grid<float> with_median_1(Grid<float> weight, const Mask& mask) {
  std::vector<float> inside;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (mask[i]) inside.push_back(weight[i]);
  }
  const float middle = median(std::move(inside));
  for (float& value : weight) value /= middle;
  return weight;
}

EdgeWeights edge_weights(const Grid<float>& weight) {
  const Grid<float> none(weight.rows(), weight.cols(), 0.0f, weight.memory());
  EdgeWeights edges{none, none};
  const auto both = [](float a, float b) { return 2.0f / (1.0f / a + 1.0f / b); };
  for_each_index(weight.rows(), [&](int row) {
    for (int col = 0; col < weight.cols(); ++col) {
      const float here = weight(row, col);
      if (col + 1 < weight.cols()) edges.east(row, col) = both(here, weight(row, col + 1));
      if (row + 1 < weight.rows()) edges.south(row, col) = both(here, weight(row + 1, col));
    }
  });
  return edges;
}

EdgeRises rises_of(const SlopeMap& slopes, const Mask& mask) {
  const Grid<float> none(mask.rows(), mask.cols(), 0.0f, slopes.memory());
  EdgeRises rises{none, none};
  for_each_index(mask.rows(), [&](int row) {
    // Rows run against y.
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector2f& here = slopes(row, col);
      if (col + 1 < mask.cols() && mask(row, col + 1)) {
        rises.east(row, col) = 0.5f * (here.x() + slopes(row, col + 1).x());
      }
      if (row + 1 < mask.rows() && mask(row + 1, col)) {
        rises.south(row, col) = -0.5f * (here.y() + slopes(row + 1, col).y());
      }
    }
  });
  return rises;
}

}  // namespace hada
