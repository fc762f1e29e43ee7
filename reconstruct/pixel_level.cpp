#include "reconstruct/pixel_level.h"

#include "core/parallel.h"
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
  level.code.assign(level.at.size(), 0);
  const int rows = mask.rows();
  const int cols = mask.cols();
  for_each_index(rows, [&](int row) {
    std::uint8_t* const codes[2] = {level.code.data() + level.at.start(row, 0),
                                    level.code.data() + level.at.start(row, 1)};
    const auto here = mask.row(row);
    const auto above = mask.row(row > 0 ? row - 1 : row);
    const auto below = mask.row(row + 1 < rows ? row + 1 : row);
    const bool has_above = row > 0;
    const bool has_below = row + 1 < rows;
    for (int col = 0; col < cols; ++col) {
      const auto c = std::size_t(col);
      const int count = (has_above && above[c]) + (has_below && below[c]) +
                        (col > 0 && here[c - 1]) + (col + 1 < cols && here[c + 1]);
      codes[col % 2][col / 2] = here[c] ? row_kernels::edge_code(count) : std::uint8_t(0);
    }
  });
  return level;
}

PixelLevel PixelLevel::of(const Mask& mask, const EdgeWeights& weights) {
  PixelLevel level(mask.memory());
  const Dealt& at = level.at = Dealt(mask.rows(), mask.cols());
  level.east.assign(at.size(), 0.0f);
  level.south.assign(at.size(), 0.0f);
  level.inverse.assign(at.size(), 0.0f);
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
      row_kernels::invert(at.block, level.inverse.data() + at.start(row, parity),
                          weights_around(level, row, parity));
    }
  });
  return level;
}

}  // namespace hada
