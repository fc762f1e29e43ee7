#include "reconstruct/coarsen.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/parallel.h"
#include "reconstruct/coarsen_kernels.h"
#include "reconstruct/extra_edges.h"
#include "reconstruct/level_rows.h"
#include "reconstruct/row_arithmetic.h"
#include "reconstruct/split_blocks.h"
#include "reconstruct/wavefront.h"

namespace hada {
namespace {

// What joins the cells of a row of blocks, and which of the blocks fall apart.
struct JoinedRow {
  std::vector<float> inside_across, inside_along, cross_across, cross_along, split;

  explicit JoinedRow(const Dealt& fine)
      : inside_across(std::size_t(fine.block)),
        inside_along(inside_across),
        cross_across(inside_across),
        cross_along(inside_across),
        split(inside_across) {}

  // The blocks [first, first + count) of a row.
  void join(const PixelLevel& fine, float least_strength, int row, int first, int count) {
    const Dealt& at = fine.at;
    const int below = std::min(2 * row + 1, at.rows);  // the guard row, if their number is odd
    const int next = std::min(2 * row + 2, at.rows);
    const auto start = [&](int r, int parity) { return at.start({r, parity, first, count}); };
    if (fine.unit()) {
      const std::uint8_t* const code = fine.code.data();
      coarsen_kernels::join(
          count,
          {code + start(2 * row, 0), code + start(2 * row, 1), code + start(below, 0),
           code + start(below, 1), code + start(next, 0), code + start(next, 1)},
          inside_across.data(), inside_along.data(), cross_across.data(), cross_along.data(),
          split.data());
      return;
    }
    const float* const east = fine.east.data();
    const float* const south = fine.south.data();
    const float* const inverse = fine.inverse.data();
    coarsen_kernels::join(
        count,
        {east + start(2 * row, 0), east + start(2 * row, 1), east + start(below, 0),
         east + start(below, 1), south + start(2 * row, 0), south + start(2 * row, 1),
         south + start(below, 0), south + start(below, 1), inverse + start(2 * row, 0),
         inverse + start(2 * row, 1), inverse + start(below, 0), inverse + start(below, 1)},
        least_strength, inside_across.data(), inside_along.data(), cross_across.data(),
        cross_along.data(), split.data());
  }

  void deal(PixelLevel& coarse, int row, int count) const {
    const auto put = [&](const std::vector<float>& from, Cells& to) {
      row_kernels::deal(count / 2, from.data(),
                        to.data() + coarse.at.start(coarse.half_row(row, 0)),
                        to.data() + coarse.at.start(coarse.half_row(row, 1)));
    };
    put(inside_across, coarse.reach_across);
    put(inside_along, coarse.reach_along);
    put(cross_across, coarse.east);
    put(cross_along, coarse.south);
  }
};

// From sums of edges inside blocks and across to what the levels keep; extra nodes left aside.
void weigh_edges(PixelLevel& coarse) {
  const Dealt& at = coarse.at;
  float* const across = coarse.reach_across.data();
  float* const along = coarse.reach_along.data();
  const auto to_reach = [=, &coarse](int row) {
    for (const int parity : {0, 1}) {
      const HalfRow half = coarse.half_row(row, parity);
      coarsen_kernels::to_reach(half.count, across + at.start(half));
      coarsen_kernels::to_reach(half.count, along + at.start(half));
    }
  };
  const auto put_in_series = [=, &coarse](int row) {
    for (const int parity : {0, 1}) {
      const HalfRow half = coarse.half_row(row, parity);
      const auto here = at.start(half);
      coarsen_kernels::in_series(half.count, coarse.east.data() + here, across + here,
                                 neighbours<row_kernels::Around>(at, across, half).right);
      coarsen_kernels::in_series(half.count, coarse.south.data() + here, along + here,
                                 neighbours<row_kernels::Around>(at, along, half).down);
    }
  };
  const auto add_up = [=, &coarse](int row) {
    for (const int parity : {0, 1}) {
      const HalfRow half = coarse.half_row(row, parity);
      const auto here = at.start(half);
      const auto weights = weights_around(coarse, half);
      coarsen_kernels::invert(half.count, coarse.inverse.data() + here, weights);
      coarsen_kernels::find_even(half.count, weights, across + here, along + here,
                                 coarse.inverse.data() + here, coarse.even.data() + here);
    }
  };
  run_wavefront(at.rows, at.size(), {{0, to_reach}, {1, put_in_series}, {1, add_up}});
}

// Of the blocks that hold the cells of two stretches.
PixelLevel::Stretch coarse_stretch(const PixelLevel& fine, int row, int block) {
  constexpr int together = Dealt::together;
  PixelLevel::Stretch found{block, 0};
  for (int r = 2 * row; r < std::min(2 * row + 2, fine.at.rows); ++r) {
    const auto [first, last] = fine.stretch(r);
    if (first == last) continue;
    found.first = std::min(found.first, first / 2 / together * together);
    found.last = std::max(found.last, (last / 2 + together - 1) / together * together);
  }
  return found.first < found.last ? found : PixelLevel::Stretch{};
}

}  // namespace

PixelLevel coarsened(PixelLevel& fine, float least_strength) {
  PixelLevel coarse(fine.memory());
  const Dealt& at = coarse.at = Dealt((fine.at.rows + 1) / 2, fine.at.half);
  for (auto* array : {&coarse.east, &coarse.south, &coarse.reach_across, &coarse.reach_along}) {
    *array = Cells(at.size(), coarse.memory());
  }
  for (int row = 0; row < at.rows; ++row) {
    coarse.stretches.push_back(coarse_stretch(fine, row, at.block));
  }
  std::vector<std::vector<int>> split_cols(std::size_t(at.rows));
  for_slices(at.rows, [&](int begin, int end) {
    JoinedRow joined(fine.at);
    for (int row = begin; row < end; ++row) {
      const auto [first, last] = blocks_of(fine, coarse, row);
      const int count = last - first;
      joined.join(fine, least_strength, row, first, count);
      joined.deal(coarse, row, count);
      if (row_kernels::largest(count, joined.split.data()) == 0.0f) continue;
      for (int block = 0; block < std::min(count, at.cols - first); ++block) {
        if (joined.split[std::size_t(block)] == 0.0f) continue;
        split_cols[std::size_t(row)].push_back(first + block);
      }
    }
  });
  split_blocks(fine, std::move(split_cols), least_strength, coarse);
  coarse.inverse = Cells(coarse.nodes(), coarse.memory());
  coarse.even = decltype(coarse.even)(at.size(), coarse.memory());
  weigh_edges(coarse);
  add_extra_edges(coarse);
  return coarse;
}

}  // namespace hada
