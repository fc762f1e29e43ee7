#include "reconstruct/slope_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "reconstruct/rise_kernels.h"
#include "reconstruct/row_kernels.h"

namespace hada {
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

SlopeSolver::SlopeSolver(const Mask& mask, std::optional<EdgeWeights> weights)
    : mask_(mask),
      weights_(std::move(weights)),
      multigrid_(weights_ ? PixelLevel::of(mask, *weights_) : PixelLevel::of(mask)),
      regions_(regions_of(mask)) {}

// A^T b: what the slopes along the edges ask of every pixel.
void SlopeSolver::set_right(const SlopeMap& slopes) {
  const Dealt& at = multigrid_.finest().at;
  const int cols = at.cols;
  const auto slopes_in = [&](int row) { return slopes.row(row).data()->data(); };
  std::vector<float> most(std::size_t(at.rows));
  for_each_index(at.rows, [&](int row) {
    most[std::size_t(row)] = row_kernels::largest(2 * cols, slopes_in(row));
  });
  // Four rises as multiples of this step add up without any rounding, and so do those of a height:
  // what a long, narrow mask makes of the rounding of sums could be seen in the height.
  const float step =
      std::exp2(
          std::ceil(std::log2(std::max(*std::max_element(most.begin(), most.end()), 0x1p-20f)))) *
      0x1p-21f;
  const float magic = multigrid_.set_step(step);
  for_slices(at.rows, [&](int begin, int end) {
    // One empty place before the first pixel, and some after the last: rows come in pairs of
    // pixels.
    std::vector<float> across(std::size_t(cols) + 1, 0.0f);
    std::vector<float> above(std::size_t(cols), 0.0f);
    std::vector<float> below(std::size_t(cols), 0.0f);
    std::vector<float> sum(std::size_t(at.stride()), 0.0f);
    const auto fill_below = [&](int row) {
      if (row < 0 || row + 1 >= at.rows) {
        std::fill(below.begin(), below.end(), 0.0f);
        return;
      }
      rise_kernels::rise_down(cols, slopes_in(row), slopes_in(row + 1), mask_.row(row).data(),
                              mask_.row(row + 1).data(), magic, below.data());
    };
    fill_below(begin - 1);
    for (int row = begin; row < end; ++row) {
      std::swap(above, below);
      fill_below(row);
      rise_kernels::rise_across(cols - 1, slopes_in(row), mask_.row(row).data(), magic,
                                across.data() + 1);
      rise_kernels::balance(cols, across.data() + 1, above.data(), below.data(), sum.data());
      float* const right = multigrid_.right().data();
      row_kernels::deal(at.block, sum.data(), right + at.start(row, 0), right + at.start(row, 1));
    }
  });
}

// A^T (b - A z) with weights, in double precision.
void SlopeSolver::set_weighted_right(const EdgeRises& rises, const Grid<double>& height) {
  const Dealt& at = multigrid_.finest().at;
  const auto pull_east = [&](int row, int col) {  // on the pixel to the right
    if (!mask_(row, col) || !mask_(row, col + 1)) return 0.0;
    return double(weights_->east(row, col)) *
           (double(rises.east(row, col)) - (height(row, col + 1) - height(row, col)));
  };
  const auto pull_south = [&](int row, int col) {  // on the pixel below
    if (!mask_(row, col) || !mask_(row + 1, col)) return 0.0;
    return double(weights_->south(row, col)) *
           (double(rises.south(row, col)) - (height(row + 1, col) - height(row, col)));
  };
  for_each_index(at.rows, [&](int row) {
    for (int col = 0; col < at.cols; ++col) {
      double sum = 0.0;
      if (mask_(row, col)) {
        if (col > 0) sum += pull_east(row, col - 1);
        if (col + 1 < at.cols) sum -= pull_east(row, col);
        if (row > 0) sum += pull_south(row - 1, col);
        if (row + 1 < at.rows) sum -= pull_south(row, col);
      }
      multigrid_.right()[std::size_t(at.cell(row, col))] = float(sum);
    }
  });
}

// Laid out as a grid, without the mean of every region.
Grid<float> SlopeSolver::levelled(const Cells& value) const {
  const Dealt& at = multigrid_.finest().at;
  Grid<float> height(at.rows, at.cols, 0.0f, mask_.memory());
  std::vector<double> sums(regions_.runs.size());
  for_slices(at.rows, [&](int begin, int end) {
    std::vector<float> whole(std::size_t(at.stride()));
    for (int row = begin; row < end; ++row) {
      row_kernels::gather(at.block, value.data() + at.start(row, 0),
                          value.data() + at.start(row, 1), whole.data());
      std::copy_n(whole.begin(), at.cols, height.row(row).begin());
      for (std::size_t run = regions_.starts[std::size_t(row)];
           run < regions_.starts[std::size_t(row) + 1]; ++run) {
        const auto [first, last, region] = regions_.runs[run];
        sums[run] = row_kernels::sum(last - first, whole.data() + first);
      }
    }
  });
  std::vector<double> mean(regions_.size.size(), 0.0);
  for (std::size_t run = 0; run < sums.size(); ++run) {
    const auto region = std::size_t(regions_.runs[run].region);
    mean[region] += sums[run] / regions_.size[region];
  }
  for_each_index(at.rows, [&](int row) {
    const auto pixels = height.row(row);
    for (const auto [first, last, region] : regions_.row(row)) {
      const auto off = float(mean[std::size_t(region)]);
      for (int col = first; col < last; ++col) pixels[std::size_t(col)] -= off;
    }
  });
  return height;
}

// Where weights differ, a pull that hardly counts at one pixel decides over a plate that hangs on
// weak edges alone: single precision loses it. So every step towards the solution is found in
// single precision, and what it leaves in double.
Grid<float> SlopeSolver::height(const EdgeRises& rises, double tolerance, int max_cycles,
                                const CycleDone& done) {
  assert(weights_);
  const Dealt& at = multigrid_.finest().at;
  Grid<double> height(at.rows, at.cols, 0.0, mask_.memory());
  set_weighted_right(rises, height);
  const auto take = [&](const Cells& step) {
    const Grid<float> part = levelled(step);
    for_each_index(at.rows, [&](int row) {
      for (int col = 0; col < at.cols; ++col) height(row, col) += double(part(row, col));
    });
    set_weighted_right(rises, height);
  };
  cycles_ = multigrid_.solve_in_steps(tolerance, max_cycles, take, done).cycles;
  Grid<float> result(at.rows, at.cols, 0.0f, mask_.memory());
  std::copy(height.begin(), height.end(), result.begin());
  return result;
}

Grid<float> SlopeSolver::height(const SlopeMap& slopes, double tolerance, int max_cycles,
                                const CycleDone& done) {
  cycles_ = 0;
  if (weights_) return height(rises_of(slopes, mask_), tolerance, max_cycles, done);
  set_right(slopes);
  const Multigrid::Solution solution = multigrid_.solve(tolerance, max_cycles, done);
  cycles_ = solution.cycles;
  return levelled(solution.value);
}

}  // namespace hada
