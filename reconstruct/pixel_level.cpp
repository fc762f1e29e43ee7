#include "reconstruct/pixel_level.h"

#include <algorithm>

#include "core/parallel.h"
#include "reconstruct/row_arithmetic.h"
#include "reconstruct/row_kernels.h"

namespace hada {
namespace {

constexpr int together = Dealt::together;

// From the first to the last code of an edge in either block of a row.
PixelLevel::Stretch stretch_of(const Dealt& at, const std::uint8_t* even, const std::uint8_t* odd) {
  const auto is_empty = [=](int first) {
    std::uint8_t found = 0;
    for (int i = first; i < first + together; ++i) found |= even[i] | odd[i];
    return found == 0;
  };
  PixelLevel::Stretch stretch{0, at.block};
  while (stretch.last > 0 && is_empty(stretch.last - together)) stretch.last -= together;
  while (stretch.first < stretch.last && is_empty(stretch.first)) stretch.first += together;
  return stretch;
}

}  // namespace

PixelLevel PixelLevel::of(const Mask& mask) {
  PixelLevel level(mask.memory());
  level.at = Dealt(mask.rows(), mask.cols());
  level.code = decltype(level.code)(level.at.size(), level.memory());
  const Dealt& at = level.at;
  level.stretches.resize(std::size_t(at.rows));
  const std::vector<std::uint8_t> outside(std::size_t(at.cols), 0);
  for_slices(at.rows, [&](int begin, int end) {
    std::vector<std::uint8_t> here(std::size_t(at.cols) + 2, 0);
    std::vector<std::uint8_t> codes(std::size_t(at.stride()), 0);
    for (int row = begin; row < end; ++row) {
      std::copy(mask.row(row).begin(), mask.row(row).end(), here.begin() + 1);
      row_kernels::edge_codes(
          at.cols, row > 0 ? mask.row(row - 1).data() : outside.data(), here.data() + 1,
          row + 1 < at.rows ? mask.row(row + 1).data() : outside.data(), codes.data());
      std::uint8_t* const even_codes = level.code.data() + at.start(row, 0);
      std::uint8_t* const odd_codes = level.code.data() + at.start(row, 1);
      row_kernels::deal(at.block, codes.data(), even_codes, odd_codes);
      level.stretches[std::size_t(row)] = stretch_of(at, even_codes, odd_codes);
    }
  });
  return level;
}

}  // namespace hada
