#include "reconstruct/smooth.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/parallel.h"
#include "reconstruct/level_rows.h"
#include "reconstruct/row_arithmetic.h"

namespace hada {
namespace {

constexpr int red = 0;
constexpr int black = 1;

// Whether the cells of a colour are in the even (0) or odd (1) columns of a row.
int parity_of(int row, int colour) {
  return (row + colour) % 2;
}

HalfRow half_of(const PixelLevel& level, int row, int colour) {
  return level.half_row(row, parity_of(row, colour));
}

void relax(const System& s, int row, int colour, float factor) {
  const PixelLevel& level = s.level;
  const HalfRow half = half_of(level, row, colour);
  const int n = half.count;
  const auto here = level.at.start(half);
  const auto values = values_around(level, s.x, half);
  float* const x = s.x + here;
  const float* const right = s.right + here;
  if (level.unit()) {
    const auto* const code = level.code.data() + here;
    if (factor == 1.0f) return row_kernels::relax(n, s.magic, x, values, right, code);
    return row_kernels::over_relax(n, factor, s.magic, x, values, right, code);
  }
  const auto weights = weights_around(level, half);
  const float* const inverse = level.inverse.data() + here;
  const auto* const even = even_at(level, here);
  if (factor == 1.0f) return row_kernels::relax(n, x, values, weights, right, inverse, even);
  return row_kernels::over_relax(n, factor, x, values, weights, right, inverse, even);
}

void relax_from_zero(const System& s, int row, int colour, float factor) {
  const PixelLevel& level = s.level;
  const HalfRow half = half_of(level, row, colour);
  const auto here = level.at.start(half);
  if (level.unit()) {
    row_kernels::relax_from_zero(half.count, factor, s.x + here, s.right + here,
                                 level.code.data() + here);
  } else {
    row_kernels::relax_from_zero(half.count, factor, s.x + here, s.right + here,
                                 level.inverse.data() + here);
  }
}

// The coarse cells of even (0) or odd (1) columns, carried towards the black cells of half a fine
// row: to the upper right corner of their block in its first row, to the lower left one in its
// second.
row_kernels::Corner corner_of(const PixelLevel& coarse, const HalfRow& fine, int parity) {
  const HalfRow half{fine.row / 2, parity, fine.first / 2, fine.count / 2};
  const bool second = fine.row % 2 == 1;
  const float* const value = coarse.value.data();
  const auto here = coarse.at.start(half);
  const auto beside = values_around(coarse, value, half);
  const auto weights = weights_around(coarse, half);
  return {value + here,
          second ? beside.left : beside.right,
          second ? weights.left : weights.right,
          coarse.reach_across.data() + here,
          second ? beside.down : beside.up,
          second ? weights.down : weights.up,
          coarse.reach_along.data() + here,
          even_at(coarse, here)};
}

// The cells of a row and colour that moved to an extra node of the coarser level.
template <class Work>
void for_moved(const PixelLevel& level, int row, int colour, const Work& work) {
  if (level.moved.empty()) return;
  const HalfRow half = half_of(level, row, colour);
  const auto begin = PixelLevel::Node(level.at.start(half));
  auto moved = std::lower_bound(level.moved.begin(), level.moved.end(), begin,
                                [](const auto& m, PixelLevel::Node cell) { return m.cell < cell; });
  for (; moved != level.moved.end() && moved->cell < begin + half.count; ++moved) {
    work(*moved);
  }
}

void correct(const System& s, const PixelLevel& coarse, float factor, int row) {
  const PixelLevel& level = s.level;
  const HalfRow half = half_of(level, row, black);
  const auto here = level.at.start(half);
  std::vector<float> moved;
  for_moved(level, row, black, [&](const PixelLevel::Moved& m) {
    moved.push_back(s.x[m.cell] + factor * coarse.value[std::size_t(m.parent)]);
  });
  const auto even = corner_of(coarse, half, 0);
  const auto odd = corner_of(coarse, half, 1);
  if (level.unit()) {
    row_kernels::add_carried(half.count / 2, factor, s.x + here, even, odd,
                             level.code.data() + here);
  } else {
    row_kernels::add_carried(half.count / 2, factor, s.x + here, even, odd,
                             level.inverse.data() + here);
  }
  auto next = moved.begin();
  for_moved(level, row, black, [&](const PixelLevel::Moved& m) { s.x[m.cell] = *next++; });
}

void residual(const System& s, const HalfRow& half, float* out) {
  const PixelLevel& level = s.level;
  const auto here = level.at.start(half);
  const auto values = values_around(level, s.x, half);
  if (level.unit()) {
    row_kernels::residual(half.count, out, s.x + here, values, s.right + here,
                          level.code.data() + here);
  } else {
    row_kernels::residual(half.count, out, s.x + here, values, weights_around(level, half),
                          s.right + here, level.inverse.data() + here, even_at(level, here));
  }
}

// right of the coarser level = the sums over blocks of what `sum_row(row, first, count, sums,
// moved)` finds: the part of a row in each, from the first cell of a block on, without the cells
// that moved to an extra node, and what belongs to those.
template <class SumRow>
void restrict_rows(const PixelLevel& level, int row, PixelLevel& coarse, const SumRow& sum_row) {
  // Two rows make one row of blocks; the second of them comes with both.
  const bool last = row + 1 == level.at.rows;
  if (row % 2 == 0 && !last) return;
  // The stretch of the blocks, which may be wider than those of the rows: beyond them all is 0.
  const auto [first, end] = blocks_of(level, coarse, row / 2);
  const int count = end - first;
  const auto block = std::size_t(level.at.block);
  thread_local std::vector<float> rows;  // here for their memory alone
  rows.resize(std::max(rows.size(), 2 * block));
  float* const upper = rows.data();
  float* const lower = upper + block;
  std::vector<std::pair<PixelLevel::Node, float>> moved;
  sum_row(row / 2 * 2, first, count, upper, moved);
  if (row % 2 == 1) {
    sum_row(row, first, count, lower, moved);
  } else {
    std::fill_n(lower, count, 0.0f);
  }
  row_kernels::add_and_deal(count / 2, upper, lower,
                            coarse.right.data() + coarse.at.start(coarse.half_row(row / 2, 0)),
                            coarse.right.data() + coarse.at.start(coarse.half_row(row / 2, 1)));
  for (const auto& [parent, rest] : moved) coarse.right[std::size_t(parent)] += rest;
}

void restrict_red(const System& s, int row, PixelLevel& coarse) {
  const PixelLevel& level = s.level;
  restrict_rows(level, row, coarse, [&](int r, int first, int count, float* sums, auto& moved) {
    const HalfRow half{r, parity_of(r, red), first, count};
    residual(s, half, sums);
    for_moved(level, r, red, [&](const PixelLevel::Moved& m) {
      const auto place = std::size_t(m.cell - level.at.start(half));
      moved.emplace_back(m.parent, std::exchange(sums[place], 0.0f));
    });
  });
}

// Of both halves of a row, which `values(half)` finds.
template <class Values>
void restrict_both(const PixelLevel& level, int row, PixelLevel& coarse, const Values& values) {
  restrict_rows(level, row, coarse, [&](int r, int first, int count, float* sums, auto& moved) {
    const float* const of[] = {values({r, 0, first, count}), values({r, 1, first, count})};
    row_kernels::add(count, of[0], of[1], sums);
    for (const int colour : {red, black}) {
      const HalfRow half{r, parity_of(r, colour), first, count};
      for_moved(level, r, colour, [&](const PixelLevel::Moved& m) {
        const auto place = std::size_t(m.cell - level.at.start(half));
        const float here = of[half.parity][place];
        moved.emplace_back(m.parent, here);
        sums[place] -= here;
      });
    }
  });
}

void restrict_right(const PixelLevel& level, int row, PixelLevel& coarse) {
  restrict_both(level, row, coarse,
                [&](const HalfRow& half) { return level.right.data() + level.at.start(half); });
}

void find_exact_residual(const System& s, const HalfRow& half, float* out) {
  const PixelLevel& level = s.level;
  assert(level.unit());
  const auto here = level.at.start(half);
  row_kernels::exact_residual(half.count, out, s.x + here, values_around(level, s.x, half),
                              s.right + here, level.code.data() + here, codes_around(level, half));
}

void restrict_exactly(const System& s, int row, PixelLevel& coarse) {
  const auto block = std::size_t(s.level.at.block);
  thread_local std::vector<float> halves;  // here for their memory alone
  halves.resize(std::max(halves.size(), 2 * block));
  restrict_both(s.level, row, coarse, [&](const HalfRow& half) {
    float* const out = halves.data() + std::size_t(half.parity) * block;
    find_exact_residual(s, half, out);
    return out;
  });
}

}  // namespace

void add_sweep(const System& s, const Relaxation& factors, std::vector<Stage>& stages) {
  stages.push_back({1, [s, factors](int row) { relax(s, row, red, factors.red); }});
  stages.push_back({1, [s, factors](int row) { relax(s, row, black, factors.black); }});
}

void add_sweep_from_zero(const System& s, float red_factor, std::vector<Stage>& stages) {
  stages.push_back({1, [s, red_factor](int row) { relax_from_zero(s, row, red, red_factor); }});
  stages.push_back({1, [s](int row) { relax(s, row, black, 1.0f); }});
}

void add_correction(const System& s, const PixelLevel& coarse, float factor,
                    std::vector<Stage>& stages) {
  stages.push_back({1, [s, &coarse, factor](int row) { correct(s, coarse, factor, row); }});
}

void add_restriction(const System& s, PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({2, [s, &coarse](int row) { restrict_red(s, row, coarse); }});
}

void add_exact_restriction(const System& s, PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({2, [s, &coarse](int row) { restrict_exactly(s, row, coarse); }});
}

void add_gathering(const PixelLevel& level, PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({0, [&level, &coarse](int row) { restrict_right(level, row, coarse); }});
}

void add_subtraction(const System& s, std::vector<Stage>& stages) {
  stages.push_back({1, [s](int row) {
                      for (const int parity : {0, 1}) {
                        const HalfRow half = s.level.half_row(row, parity);
                        find_exact_residual(s, half, s.right + s.level.at.start(half));
                      }
                    }});
}

}  // namespace hada
