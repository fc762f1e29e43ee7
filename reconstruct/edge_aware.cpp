#include "reconstruct/edge_aware.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "reconstruct/regions.h"
#include "reconstruct/slope_solver.h"

namespace hada {
namespace {

// No pair is cut apart: a plate that is free on all sides would lose its height.
constexpr float least_weight = 1e-5f;

struct Weighted {
  EdgeWeights weights;
  EdgeRises rises;
  double energy = 0.0;
};

// The share of the pixel at `(row, col)` that its step backwards (left, up) gets.
class Sides {
 public:
  Sides(const Grid<float>& height, const Grid<float>& facing, const Mask& mask, double sharpness)
      : height_(height), facing_(facing), mask_(mask), sharpness_(sharpness) {}

  double back(int row, int col, int rows, int cols) const {
    const auto step = [&](int sign) {
      const int r = row + sign * rows;
      const int c = col + sign * cols;
      if (!mask_.contains(r, c) || !mask_(r, c)) return 0.0;
      return double(facing_(row, col)) * (double(height_(r, c)) - height_(row, col));
    };
    const double forward = step(1);
    const double backward = step(-1);
    return 1.0 / (1.0 + std::exp(-sharpness_ * (forward * forward - backward * backward)));
  }

 private:
  const Grid<float>& height_;
  const Grid<float>& facing_;
  const Mask& mask_;
  double sharpness_;
};

// of_pixels: their weights, 1 in the median; or null
Weighted weighted_by(const Grid<float>& height, const SlopeMap& slopes, const Grid<float>& facing,
                     const Mask& mask, double sharpness, const Grid<float>* of_pixels) {
  const int rows = mask.rows();
  const int cols = mask.cols();
  Weighted w{{Grid<float>(rows, cols), Grid<float>(rows, cols)},
             {Grid<float>(rows, cols), Grid<float>(rows, cols)}};
  const Sides sides(height, facing, mask, sharpness);
  std::vector<double> energy(std::size_t(rows), 0.0);
  // Two equations of one step make one, with the sum of their weights and the mean of their slopes.
  const auto join = [](double a, double p, double b, double q, double step, float& weight,
                       float& rise) {
    weight = std::max(float(a + b), least_weight);
    rise = float((a * p + b * q) / std::max(a + b, 1e-30));
    return a * (step - p) * (step - p) + b * (step - q) * (step - q);
  };
  for_each_index(rows, [&](int row) {
    for (int col = 0; col < cols; ++col) {
      if (!mask(row, col)) continue;
      const auto squared = [&](int r, int c) {
        return double(facing(r, c)) * facing(r, c) * (of_pixels ? double((*of_pixels)(r, c)) : 1.0);
      };
      double& sum = energy[std::size_t(row)];
      if (col + 1 < cols && mask(row, col + 1)) {
        sum += join(squared(row, col) * (1.0 - sides.back(row, col, 0, 1)), slopes(row, col).x(),
                    squared(row, col + 1) * sides.back(row, col + 1, 0, 1),
                    slopes(row, col + 1).x(), double(height(row, col + 1)) - height(row, col),
                    w.weights.east(row, col), w.rises.east(row, col));
      }
      if (row + 1 < rows && mask(row + 1, col)) {
        sum += join(squared(row, col) * (1.0 - sides.back(row, col, 1, 0)), -slopes(row, col).y(),
                    squared(row + 1, col) * sides.back(row + 1, col, 1, 0),
                    -slopes(row + 1, col).y(), double(height(row + 1, col)) - height(row, col),
                    w.weights.south(row, col), w.rises.south(row, col));
      }
    }
  });
  for (const double of_row : energy) w.energy += of_row;
  return w;
}

// Regions cut at weak pairs.
void find_parts(const EdgeWeights& weights, const Grid<float>& facing, const Mask& mask,
                EdgeAware& found) {
  constexpr double least_share = 0.3;
  const Regions regions = regions_of(mask);
  found.part = Grid<int>(mask.rows(), mask.cols());
  found.part_size = {0};
  std::vector<int> largest(regions.size.size(), 0);
  std::vector<std::pair<int, int>> part;
  const auto holds = [&](float weight, int row, int col, int r, int c) {
    return double(weight) >= least_share * facing(row, col) * facing(r, c);
  };
  const auto reach = [&](int row, int col) {
    if (!mask(row, col) || found.part(row, col) != 0) return;
    found.part(row, col) = int(found.part_size.size());
    part.emplace_back(row, col);
  };
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      part.clear();
      reach(row, col);
      for (std::size_t next = 0; next < part.size(); ++next) {
        const auto [r, c] = part[next];
        const auto& [east, south] = weights;
        if (c + 1 < mask.cols() && holds(east(r, c), r, c, r, c + 1)) reach(r, c + 1);
        if (c > 0 && holds(east(r, c - 1), r, c, r, c - 1)) reach(r, c - 1);
        if (r + 1 < mask.rows() && holds(south(r, c), r, c, r + 1, c)) reach(r + 1, c);
        if (r > 0 && holds(south(r - 1, c), r, c, r - 1, c)) reach(r - 1, c);
      }
      if (part.empty()) continue;
      found.part_size.push_back(int(part.size()));
      int& most = largest[std::size_t(regions.label(row, col))];
      most = std::max(most, int(part.size()));
    }
  }
  found.held_together = std::accumulate(largest.begin(), largest.end(), 0.0) /
                        (double(mask.size()) - regions.size[0]);
}

}  // namespace

EdgeAware edge_aware_height(const SlopeMap& slopes, const Grid<float>& facing, const Mask& mask,
                            const EdgeAwareOptions& options) {
  EdgeAware result;
  result.height = Grid<float>(mask.rows(), mask.cols());
  Grid<float>& height = result.height;
  std::optional<Grid<float>> weight;
  if (options.weight) weight = with_median_1(*options.weight, mask);
  const Grid<float>* const of_pixels = weight ? &*weight : nullptr;
  double last = 0.0;
  for (int round = 0; round < options.max_rounds; ++round) {
    Weighted w = weighted_by(height, slopes, facing, mask, options.sharpness, of_pixels);
    if (round > 1 && std::abs(w.energy - last) < options.least_change * last) break;
    last = w.energy;
    height = SlopeSolver(mask, std::move(w.weights)).height(w.rises, options.tolerance_px, 40);
    if (options.done) options.done(round + 1);
  }
  const auto sides = weighted_by(height, slopes, facing, mask, options.sharpness, nullptr);
  find_parts(sides.weights, facing, mask, result);
  return result;
}

void place_parts(EdgeAware& found, const Grid<float>& smooth) {
  std::vector<double> lift(found.part_size.size(), 0.0);
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const auto part = std::size_t(found.part[i]);
    lift[part] += (double(smooth[i]) - found.height[i]) / std::max(found.part_size[part], 1);
  }
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const int part = found.part[i];
    if (part != 0) found.height[i] += float(lift[std::size_t(part)]);
  }
}

}  // namespace hada
