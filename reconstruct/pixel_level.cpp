#include "reconstruct/pixel_level.h"

#include <algorithm>

#include "core/parallel.h"
#include "reconstruct/row_arithmetic.h"
#include "reconstruct/row_kernels.h"

namespace hada {

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

}  // namespace hada
