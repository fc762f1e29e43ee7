#include "reconstruct/smooth.h"

#include <algorithm>
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

void relax(const System& s, int row, int colour, float factor) {
  const PixelLevel& level = s.level;
  const int parity = parity_of(row, colour);
  const int n = level.at.block;
  const auto here = level.at.start(row, parity);
  const auto values = values_around(level, s.x, row, parity);
  float* const x = s.x + here;
  const float* const right = s.right + here;
  if (level.unit()) {
    const auto* const code = level.code.data() + here;
    if (factor == 1.0f) return row_kernels::relax(n, x, values, right, code);
    return row_kernels::over_relax(n, factor, x, values, right, code);
  }
  const auto weights = weights_around(level, row, parity);
  const float* const inverse = level.inverse.data() + here;
  const auto* const even = even_at(level, here);
  if (factor == 1.0f) return row_kernels::relax(n, x, values, weights, right, inverse, even);
  return row_kernels::over_relax(n, factor, x, values, weights, right, inverse, even);
}

void relax_from_zero(const System& s, int row, int colour, float factor) {
  const PixelLevel& level = s.level;
  const auto here = level.at.start(row, parity_of(row, colour));
  if (level.unit()) {
    row_kernels::relax_from_zero(level.at.block, factor, s.x + here, s.right + here,
                                 level.code.data() + here);
  } else {
    row_kernels::relax_from_zero(level.at.block, factor, s.x + here, s.right + here,
                                 level.inverse.data() + here);
  }
}

// The coarse cells of even (0) or odd (1) columns, carried towards the black cells of a fine row:
// to the upper right corner of their block in its first row, to the lower left one in its second.
row_kernels::Corner corner_of(const PixelLevel& coarse, int fine_row, int parity) {
  const Dealt& at = coarse.at;
  const int row = fine_row / 2;
  const bool second = fine_row % 2 == 1;
  const float* const value = coarse.value.data();
  const auto here = at.start(row, parity);
  const auto beside = neighbours<row_kernels::Around>(at, value, row, parity);
  const auto weights = weights_around(coarse, row, parity);
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
  const auto begin = PixelLevel::Node(level.at.start(row, parity_of(row, colour)));
  auto moved = std::lower_bound(level.moved.begin(), level.moved.end(), begin,
                                [](const auto& m, PixelLevel::Node cell) { return m.cell < cell; });
  for (; moved != level.moved.end() && moved->cell < begin + level.at.block; ++moved) {
    work(*moved);
  }
}

void correct(const System& s, const PixelLevel& coarse, int row) {
  const PixelLevel& level = s.level;
  const auto here = level.at.start(row, parity_of(row, black));
  std::vector<float> moved;
  for_moved(level, row, black, [&](const PixelLevel::Moved& m) {
    moved.push_back(s.x[m.cell] + coarse.value[std::size_t(m.parent)]);
  });
  const auto even = corner_of(coarse, row, 0);
  const auto odd = corner_of(coarse, row, 1);
  if (level.unit()) {
    row_kernels::add_carried(level.at.block / 2, s.x + here, even, odd, level.code.data() + here);
  } else {
    row_kernels::add_carried(level.at.block / 2, s.x + here, even, odd,
                             level.inverse.data() + here);
  }
  auto next = moved.begin();
  for_moved(level, row, black, [&](const PixelLevel::Moved& m) { s.x[m.cell] = *next++; });
}

void residual(const System& s, int row, int colour, float* out) {
  const PixelLevel& level = s.level;
  const int parity = parity_of(row, colour);
  const auto here = level.at.start(row, parity);
  const auto values = values_around(level, s.x, row, parity);
  if (level.unit()) {
    row_kernels::residual(level.at.block, out, s.x + here, values, s.right + here,
                          level.code.data() + here);
  } else {
    row_kernels::residual(level.at.block, out, s.x + here, values,
                          weights_around(level, row, parity), s.right + here,
                          level.inverse.data() + here, even_at(level, here));
  }
}

// right of the coarser level = the sums over blocks of what `sum_row(row, sums, moved)` finds: the
// part of a row in each, without the cells that moved to an extra node, and what belongs to those.
template <class SumRow>
void restrict_rows(const PixelLevel& level, int row, PixelLevel& coarse, const SumRow& sum_row) {
  // Two rows make one row of blocks; the second of them comes with both.
  const bool last = row + 1 == level.at.rows;
  if (row % 2 == 0 && !last) return;
  const auto block = std::size_t(level.at.block);
  thread_local std::vector<float> rows;  // here for their memory alone
  rows.resize(std::max(rows.size(), 2 * block));
  float* const upper = rows.data();
  float* const lower = upper + block;
  std::vector<std::pair<PixelLevel::Node, float>> moved;
  sum_row(row / 2 * 2, upper, moved);
  if (row % 2 == 1) {
    sum_row(row, lower, moved);
  } else {
    std::fill_n(lower, block, 0.0f);
  }
  row_kernels::add_and_deal(level.at.block / 2, upper, lower,
                            coarse.right.data() + coarse.at.start(row / 2, 0),
                            coarse.right.data() + coarse.at.start(row / 2, 1));
  for (const auto& [parent, rest] : moved) coarse.right[std::size_t(parent)] += rest;
}

void restrict_red(const System& s, int row, PixelLevel& coarse) {
  const PixelLevel& level = s.level;
  restrict_rows(level, row, coarse, [&](int r, float* sums, auto& moved) {
    residual(s, r, red, sums);
    for_moved(level, r, red, [&](const PixelLevel::Moved& m) {
      const auto place = std::size_t(m.cell - level.at.start(r, parity_of(r, red)));
      moved.emplace_back(m.parent, std::exchange(sums[place], 0.0f));
    });
  });
}

void restrict_right(const PixelLevel& level, int row, PixelLevel& coarse) {
  restrict_rows(level, row, coarse, [&](int r, float* sums, auto& moved) {
    const float* const right = level.right.data();
    row_kernels::add(level.at.block, right + level.at.start(r, 0), right + level.at.start(r, 1),
                     sums);
    for (const int colour : {red, black}) {
      for_moved(level, r, colour, [&](const PixelLevel::Moved& m) {
        const auto place = std::size_t(m.cell - level.at.start(r, parity_of(r, colour)));
        const float here = right[std::size_t(m.cell)];
        moved.emplace_back(m.parent, here);
        sums[place] -= here;
      });
    }
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

void add_correction(const System& s, const PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({1, [s, &coarse](int row) { correct(s, coarse, row); }});
}

void add_restriction(const System& s, PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({2, [s, &coarse](int row) { restrict_red(s, row, coarse); }});
}

void add_gathering(const PixelLevel& level, PixelLevel& coarse, std::vector<Stage>& stages) {
  stages.push_back({0, [&level, &coarse](int row) { restrict_right(level, row, coarse); }});
}

void add_subtraction(const System& s, std::vector<Stage>& stages) {
  stages.push_back({1, [s](int row) {
                      const PixelLevel& level = s.level;
                      for (const int parity : {0, 1}) {
                        const auto here = level.at.start(row, parity);
                        const auto values = values_around(level, s.x, row, parity);
                        if (level.unit()) {
                          row_kernels::subtract_image(level.at.block, s.right + here, s.x + here,
                                                      values, level.code.data() + here,
                                                      codes_around(level, row, parity));
                        } else {
                          row_kernels::subtract_image(level.at.block, s.right + here, s.x + here,
                                                      values, weights_around(level, row, parity));
                        }
                      }
                    }});
}

void add_settling(const System& s, float factor, float magic, Grid<float>& total,
                  std::vector<Stage>& stages) {
  stages.push_back({1, [=, &total](int row) {
                      const Dealt& at = s.level.at;
                      float* const even = s.x + at.start(row, 0);
                      row_kernels::settle(int(at.stride()), factor, magic, even);
                      row_kernels::add_gathered(at.cols, 1.0f, even, s.x + at.start(row, 1),
                                                total.row(row).data());
                    }});
}

}  // namespace hada
