#include "reconstruct/slope_solver.h"

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <new>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

TEST(SlopeSolver, IsLinearInTheSlopes) {
  const Mask mask = torn_mask(40, 50, 1);
  SlopeMap slopes = slopes_of(waves(40, 50).normals, mask);
  SlopeSolver solver(mask);
  const auto height = solver.height(slopes, 1e-6, 100);
  for (auto& slope : slopes) slope *= 2.0f;
  const auto twice = solver.height(slopes, 1e-6, 100);
  for (std::size_t i = 0; i < height.size(); ++i) ASSERT_NEAR(twice[i], 2.0f * height[i], 2e-5f);
}

TEST(SlopeSolver, ReturnsTheSameBytesWhereverTheMaskLies) {
  class Counting : public std::pmr::memory_resource {
   public:
    std::size_t most = 0;

   private:
    void* do_allocate(std::size_t bytes, std::size_t) override {
      most = std::max(most, bytes);
      return ::operator new(bytes);
    }
    void do_deallocate(void* memory, std::size_t, std::size_t) override {
      ::operator delete(memory);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override {
      return this == &other;
    }
  };
  Counting counting;
  const Mask mask = torn_mask(200, 170, 3);
  Mask elsewhere(200, 170, 0, &counting);
  std::copy(mask.begin(), mask.end(), elsewhere.begin());
  const SlopeMap slopes = slopes_of(waves(200, 170).normals, mask);
  const auto height = SlopeSolver(elsewhere).height(slopes, 1e-5, 100);
  EXPECT_EQ(height, SlopeSolver(mask).height(slopes, 1e-5, 100));
  EXPECT_EQ(height.memory(), &counting);
  EXPECT_GE(counting.most, mask.size() * sizeof(float));
}

TEST(SlopeSolver, SettlesInAFewCyclesAtAnySize) {
  // A plain conjugate gradient needs in the order of one iteration per pixel of the width.
  for (const int size : {64, 256, 512}) {
    const Relief relief = waves(size, size);
    const Mask mask = full_mask(relief.extent);
    const SlopeMap slopes = slopes_of(relief.normals, mask);
    SlopeSolver solver(mask);
    const auto settled = solver.height(slopes, 0.0, 20);
    EXPECT_LT(rms_difference(solver.height(slopes, 1e-5, 100), settled, mask), 1e-5);
    EXPECT_LE(solver.cycles(), 6);
  }
}

// A height that the rises of its slopes agree with exactly, whatever the mask: each slope is chosen
// so that the mean with the one before is the step between the two.
struct Stepped {
  SlopeMap slopes;
  Grid<double> height;
};

Stepped stepped(int rows, int cols) {
  const auto z = [](double row, double col) {
    return 40.0 * std::sin(0.011 * col + 0.007 * row) + 2.0 * std::sin(0.2 * col - 0.15 * row);
  };
  Stepped made{SlopeMap(rows, cols, Eigen::Vector2f::Zero()), Grid<double>(rows, cols)};
  for (int row = 0; row < rows; ++row) {
    double slope = z(row, 0.5) - z(row, -0.5);
    for (int col = 0; col < cols; ++col) {
      made.height(row, col) = z(row, col);
      made.slopes(row, col).x() = float(slope);
      slope = 2.0 * (z(row, col + 1) - z(row, col)) - slope;
    }
  }
  for (int col = 0; col < cols; ++col) {
    double slope = z(-0.5, col) - z(0.5, col);
    for (int row = 0; row < rows; ++row) {
      made.slopes(row, col).y() = float(slope);
      slope = 2.0 * (z(row, col) - z(row + 1, col)) - slope;
    }
  }
  return made;
}

double error_of(const Grid<float>& height, const Grid<double>& truth, const Mask& mask) {
  const Regions regions = regions_of(mask);
  std::vector<double> mean(regions.size.size(), 0.0);
  const auto for_pixels = [&](const auto& work) {
    for (int row = 0; row < mask.rows(); ++row) {
      for (const auto& run : regions.row(row)) {
        for (int col = run.first; col < run.last; ++col) {
          work(std::size_t(run.region), double(height(row, col)) - truth(row, col));
        }
      }
    }
  };
  for_pixels(
      [&](std::size_t region, double error) { mean[region] += error / regions.size[region]; });
  double sum = 0.0;
  for_pixels([&](std::size_t region, double error) { sum += std::pow(error - mean[region], 2); });
  return std::sqrt(sum / double(mask.size() - std::size_t(regions.size[0])));
}

TEST(SlopeSolver, IsExactOnMasksThatAreHardToCrossAndNeedsFewMoreCycles) {
  constexpr int size = 400;
  const Stepped made = stepped(size, size);
  Mask snake(size, size, 1);    // slits 2 px wide, open at the top and the bottom in turn
  Mask bridged(size, size, 1);  // walls with a bridge of a single pixel
  Mask holed(size, size, 1);    // every sixth pixel missing
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const int slit = col / 25;
      const bool open = slit % 2 == 0 ? row < 30 : row >= size - 30;
      if (col % 25 > 22 && !open) snake(row, col) = 0;
      if (col % 50 == 49) bridged(row, col) = row == 37 * (col / 50 + 1);
      if (row % 80 == 79) bridged(row, col) = col % 50 == 20;
      if (uniform(3, row, col) < 1.0 / 6.0) holed(row, col) = 0;
    }
  }
  for (const auto& [mask, most] :
       {std::pair(&snake, 20), std::pair(&bridged, 20), std::pair(&holed, 20)}) {
    SlopeSolver solver(*mask);
    // Asked for 1e-5; the estimate of the error may be off by a factor of a few.
    EXPECT_LT(error_of(solver.height(made.slopes, 1e-5, 100), made.height, *mask), 5e-5);
    EXPECT_LE(solver.cycles(), most);
  }
}

TEST(SlopeSolver, IsExactWhereRowsBeginAndEndAnywhere) {
  constexpr int rows = 301;
  constexpr int cols = 423;
  const Stepped made = stepped(rows, cols);
  Mask discs(rows, cols, 0);  // side by side, with empty rows above, between and below
  Mask bent(rows, cols, 0);   // rows begin further left, then further right, than those above
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      discs(row, col) =
          std::hypot(row - 80, col - 330) < 60.0 || std::hypot(row - 220, col - 100) < 63.0;
      const int from = row < 100 ? 200 : row < 200 ? 33 : 310;
      bent(row, col) = col >= from && col < (row < 200 ? 352 : cols);
    }
  }
  for (const Mask* const mask : {&discs, &bent}) {
    SlopeSolver solver(*mask);
    // 1e-5 px is asked for; the heights of 42 px are rounded to 4e-6.
    const Grid<float> height = solver.height(made.slopes, 1e-5, 50);
    EXPECT_LT(error_of(height, made.height, *mask), 2e-5);
    EXPECT_EQ(solver.height(made.slopes, 1e-5, 50), height);  // and nothing stays behind
  }
}

TEST(SlopeSolver, IsExactWithWeightsThatDifferByAMillion) {
  constexpr int size = 200;
  const Stepped made = stepped(size, size);
  const Mask mask = torn_mask(size, size, 2);
  // Whatever the weights, the rises agree with one height.
  for (const int kind : {0, 1, 2}) {
    Grid<float> weight(size, size);
    for (int row = 0; row < size; ++row) {
      for (int col = 0; col < size; ++col) {
        const bool in_disc = std::hypot(row - 120, col - 60) < 40.0 || (row + col) % 50 < 8;
        const double exponent = kind == 0   ? (in_disc ? -6.0 : 0.0)
                                : kind == 1 ? -3.0 + 3.0 * std::sin(0.05 * row - 0.03 * col)
                                            : -6.0 * uniform(8, row, col);
        weight(row, col) = float(std::pow(10.0, exponent));
      }
    }
    SlopeSolver solver(mask, edge_weights(weight));
    EXPECT_LT(error_of(solver.height(made.slopes, 1e-5, 100), made.height, mask), 2e-5) << kind;
    // A rate of 0.1 a cycle, from a height of 30 px: 7 cycles.
    EXPECT_LE(solver.cycles(), 7) << kind;
  }
}

}  // namespace
}  // namespace hada
