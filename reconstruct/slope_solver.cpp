#include "reconstruct/slope_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "reconstruct/rise_kernels.h"
#include "reconstruct/row_arithmetic.h"

namespace hada {
namespace {

constexpr int rows_asked = 16;  // every one of so many for a first idea of the largest slope

// Four rises as multiples of this step add up without any rounding, and so do those of a height:
// what a long, narrow mask makes of the rounding of sums could be seen in the height.
float step_of(float largest_slope) {
  return std::exp2(std::ceil(std::log2(std::max(largest_slope, 0x1p-20f)))) * 0x1p-21f;
}

// The columns of a row that hold the stretch of a level.
struct Columns {
  int first = 0;
  int last = 0;  // one beyond
  int count() const { return last - first; }
};

Columns columns_of(const PixelLevel& level, int row) {
  if (row < 0 || row >= level.at.rows) return {};
  const auto [first, last] = level.stretch(row);
  return {2 * first, std::min(2 * last, level.at.cols)};
}

float largest_slope(const SlopeMap& slopes, int row, const Columns& cols) {
  return row_kernels::largest(2 * cols.count(), slopes.row(row).data()->data() + 2 * cols.first);
}

}  // namespace

SlopeSolver::SlopeSolver(const Mask& mask, std::optional<EdgeWeights> weights)
    : mask_(mask), regions_(regions_of(mask)) {
  if (weights) {
    weighted_.emplace(mask, std::move(*weights));
  } else {
    multigrid_.emplace(PixelLevel::of(mask));
  }
}

// A^T b: what the slopes along the edges ask of every pixel.
void SlopeSolver::set_right(const SlopeMap& slopes) {
  float most = 0.0f;
  for (int row = 0; row < slopes.rows(); row += rows_asked) {
    most = std::max(most, largest_slope(slopes, row, columns_of(multigrid_->finest(), row)));
  }
  // The step is nearly always the right one, and the slopes are read once.
  const float step = step_of(most);
  most = set_right(slopes, step);
  if (step_of(most) > step) set_right(slopes, step_of(most));
}

// Returns the largest slope.
float SlopeSolver::set_right(const SlopeMap& slopes, float step) {
  const PixelLevel& level = multigrid_->finest();
  const Dealt& at = level.at;
  const auto slopes_at = [&](int row, int col) { return (slopes.row(row).data() + col)->data(); };
  const auto mask_at = [&](int row, int col) { return mask_.row(row).data() + col; };
  std::vector<float> most(std::size_t(at.rows));
  const float magic = multigrid_->set_step(step);
  for_slices(at.rows, [&](int begin, int end) {
    // One empty place before the first pixel, and some after the last: rows come in pairs of
    // pixels.
    std::vector<float> across(std::size_t(at.cols) + 1, 0.0f);
    std::vector<float> above(std::size_t(at.cols), 0.0f);
    std::vector<float> below(std::size_t(at.cols), 0.0f);
    std::vector<float> sum(std::size_t(at.stride()), 0.0f);
    // Over the stretches of both rows, since `balance` reads it over either; a rise needs both.
    const auto fill_below = [&](int row) {
      const Columns a = columns_of(level, row);
      const Columns b = columns_of(level, row + 1);
      if (a.count() == 0 || b.count() == 0) {
        std::fill(below.begin(), below.end(), 0.0f);
        return;
      }
      const int first = std::min(a.first, b.first);
      rise_kernels::rise_down(std::max(a.last, b.last) - first, slopes_at(row, first),
                              slopes_at(row + 1, first), mask_at(row, first),
                              mask_at(row + 1, first), magic, below.data() + first);
    };
    fill_below(begin - 1);
    for (int row = begin; row < end; ++row) {
      const Columns cols = columns_of(level, row);
      most[std::size_t(row)] = largest_slope(slopes, row, cols);
      std::swap(above, below);
      fill_below(row);
      if (cols.count() == 0) continue;
      const int first = cols.first;
      float* const rise = across.data() + 1 + first;
      rise[-1] = 0.0f;  // from another row, which began further left
      rise[cols.count() - 1] = 0.0f;
      rise_kernels::rise_across(cols.count() - 1, slopes_at(row, first), mask_at(row, first), magic,
                                rise);
      rise_kernels::balance(cols.count(), rise, above.data() + first, below.data() + first,
                            sum.data() + first);
      // Behind the last column of the map `sum` is still 0.
      row_kernels::deal(level.half_row(row, 0).count, sum.data() + first,
                        multigrid_->right().data() + at.start(level.half_row(row, 0)),
                        multigrid_->right().data() + at.start(level.half_row(row, 1)));
    }
  });
  return *std::max_element(most.begin(), most.end());
}

void SlopeSolver::take_means_off(Grid<float>& height) const {
  std::vector<double> sums(regions_.runs.size());
  // work(run, how many pixels, the first of them)
  const auto for_runs = [&](const auto& work) {
    for_each_index(height.rows(), [&](int row) {
      const std::size_t end = regions_.starts[std::size_t(row) + 1];
      for (std::size_t run = regions_.starts[std::size_t(row)]; run < end; ++run) {
        const auto [first, last, region] = regions_.runs[run];
        work(run, last - first, height.row(row).data() + first);
      }
    });
  };
  for_runs([&](std::size_t run, int count, const float* pixels) {
    sums[run] = row_kernels::sum(count, pixels);
  });
  std::vector<double> mean(regions_.size.size(), 0.0);
  for (std::size_t run = 0; run < sums.size(); ++run) {
    const auto region = std::size_t(regions_.runs[run].region);
    mean[region] += sums[run] / regions_.size[region];
  }
  for_runs([&](std::size_t run, int count, float* pixels) {
    row_kernels::subtract(count, float(mean[std::size_t(regions_.runs[run].region)]), pixels);
  });
}

Grid<float> SlopeSolver::levelled(const Grid<double>& value) const {
  std::vector<double> mean(regions_.size.size(), 0.0);
  for (int row = 0; row < value.rows(); ++row) {
    for (const auto [first, last, region] : regions_.row(row)) {
      double& of_region = mean[std::size_t(region)];
      for (int col = first; col < last; ++col) {
        of_region += value(row, col) / regions_.size[std::size_t(region)];
      }
    }
  }
  Grid<float> height(value.rows(), value.cols(), 0.0f, mask_.memory());
  for_each_index(value.rows(), [&](int row) {
    for (const auto [first, last, region] : regions_.row(row)) {
      for (int col = first; col < last; ++col) {
        height(row, col) = float(value(row, col) - mean[std::size_t(region)]);
      }
    }
  });
  return height;
}

Grid<float> SlopeSolver::height(const EdgeRises& rises, double tolerance, int max_cycles,
                                const CycleDone& done) {
  assert(weighted_);
  const WeightedSolver::Solution solution = weighted_->solve(rises, tolerance, max_cycles, done);
  cycles_ = solution.cycles;
  return levelled(solution.height);
}

Grid<float> SlopeSolver::height(const SlopeMap& slopes, double tolerance, int max_cycles,
                                const CycleDone& done) {
  cycles_ = 0;
  if (weighted_) return height(rises_of(slopes, mask_), tolerance, max_cycles, done);
  set_right(slopes);
  Multigrid::Solution solution = multigrid_->solve(tolerance, max_cycles, done);
  cycles_ = solution.cycles;
  take_means_off(solution.value);
  return std::move(solution.value);
}

}  // namespace hada
