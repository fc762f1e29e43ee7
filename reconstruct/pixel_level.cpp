#include "reconstruct/pixel_level.h"

#include <algorithm>

#include "core/parallel.h"
#include "reconstruct/coarsen_kernels.h"
#include "reconstruct/level_rows.h"

namespace hada {

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

PixelLevel PixelLevel::of(const Mask& mask) {
  PixelLevel level(mask.memory());
  level.at = Dealt(mask.rows(), mask.cols());
  level.code = decltype(level.code)(level.at.size(), level.memory());
  const Dealt& at = level.at;
  const std::vector<std::uint8_t> outside(std::size_t(at.cols), 0);
  for_slices(at.rows, [&](int begin, int end) {
    std::vector<std::uint8_t> here(std::size_t(at.cols) + 2, 0);
    std::vector<std::uint8_t> codes(std::size_t(at.stride()), 0);
    for (int row = begin; row < end; ++row) {
      std::copy(mask.row(row).begin(), mask.row(row).end(), here.begin() + 1);
      row_kernels::edge_codes(
          at.cols, row > 0 ? mask.row(row - 1).data() : outside.data(), here.data() + 1,
          row + 1 < at.rows ? mask.row(row + 1).data() : outside.data(), codes.data());
      row_kernels::deal(at.block, codes.data(), level.code.data() + at.start(row, 0),
                        level.code.data() + at.start(row, 1));
    }
  });
  return level;
}

PixelLevel PixelLevel::of(const Mask& mask, const EdgeWeights& weights) {
  PixelLevel level(mask.memory());
  const Dealt& at = level.at = Dealt(mask.rows(), mask.cols());
  for (auto* array : {&level.east, &level.south, &level.inverse}) {
    *array = Cells(at.size(), level.memory());
  }
  for_each_index(at.rows, [&](int row) {
    for (int col = 0; col < at.cols; ++col) {
      if (!mask(row, col)) continue;
      const auto cell = std::size_t(at.cell(row, col));
      if (col + 1 < at.cols && mask(row, col + 1)) level.east[cell] = weights.east(row, col);
      if (row + 1 < at.rows && mask(row + 1, col)) level.south[cell] = weights.south(row, col);
    }
  });
  for_each_index(at.rows, [&](int row) {
    for (const int parity : {0, 1}) {
      coarsen_kernels::invert(at.block, level.inverse.data() + at.start(row, parity),
                              weights_around(level, row, parity));
    }
  });
  return level;
}

}  // namespace hada
