#include "reconstruct/integrate.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <fmt/format.h>

#include "core/error.h"
#include "reconstruct/edge_aware.h"
#include "reconstruct/slope_solver.h"

namespace hada {
namespace {

void require_pixels(const Mask& mask) {
  if (std::none_of(mask.begin(), mask.end(), [](auto inside) { return inside != 0; })) {
    throw Error("the mask is empty: there is no pixel to find a height for; check the mask");
  }
}

// One equation (row of A, entry of b) for every pair of neighbours, in pixels.
struct Equations {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd rise;
};

Equations equations_of(const NormalMap& normals, const Mask& mask, const Grid<int>& unknown,
                       int unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> rises;
  const auto add = [&](int row, int col, int other_row, int other_col, double rise) {
    const int equation = int(rises.size());
    entries.emplace_back(equation, unknown(other_row, other_col), 1.0);
    entries.emplace_back(equation, unknown(row, col), -1.0);
    rises.push_back(rise);
  };
  const auto slope = [&](int row, int col, int axis) {
    const Eigen::Vector3d normal = normals(row, col).cast<double>();
    return -normal[axis] / normal.z();
  };
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      if (mask.contains(row, col + 1) && mask(row, col + 1)) {
        add(row, col, row, col + 1, 0.5 * (slope(row, col, 0) + slope(row, col + 1, 0)));
      }
      if (mask.contains(row + 1, col) && mask(row + 1, col)) {
        add(row, col, row + 1, col, -0.5 * (slope(row, col, 1) + slope(row + 1, col, 1)));
      }
    }
  }
  Equations equations{Eigen::SparseMatrix<double>(int(rises.size()), unknowns),
                      Eigen::Map<Eigen::VectorXd>(rises.data(), Eigen::Index(rises.size()))};
  equations.matrix.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

// A region without its mean; which pixels make a region is read off the matrix itself.
void subtract_region_means(const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd& height) {
  std::vector<char> seen(std::size_t(height.size()), 0);
  for (int start = 0; start < height.size(); ++start) {
    if (seen[std::size_t(start)]) continue;
    std::vector<int> region{start};
    seen[std::size_t(start)] = 1;
    double sum = 0.0;
    for (std::size_t next = 0; next < region.size(); ++next) {
      sum += height[region[next]];
      for (Eigen::SparseMatrix<double>::InnerIterator entry(laplacian, region[next]); entry;
           ++entry) {
        if (seen[std::size_t(entry.row())]) continue;
        seen[std::size_t(entry.row())] = 1;
        region.push_back(int(entry.row()));
      }
    }
    for (const int pixel : region) height[pixel] -= sum / double(region.size());
  }
}

Grid<float> height_px(const SlopeMap& slopes, const Mask& mask, const IntegrateOptions& options) {
  std::optional<EdgeWeights> weights;
  if (!options.weight.empty()) weights = edge_weights(options.weight);
  return SlopeSolver(mask, std::move(weights))
      .height(slopes, options.tolerance_px, options.max_cycles, options.done);
}

Grid<float> in_units(Grid<float> height, double pitch, const std::optional<PinHole>& pin_hole) {
  for (float& value : height) value = float(value * pitch);
  if (pin_hole) height_from_log_depth(height, pin_hole->focal_px.x() * pitch);
  return height;
}

// A pixel at an outline is a mixture of two surfaces: where it looks away by more than 81 degrees,
// its slope would decide how far the one lies behind the other.
constexpr float least_facing_at_jumps = 0.15f;
constexpr double least_rms = 0.02;   // px; below, whatever there is can stay
constexpr double least_share = 0.5;  // normal errors have 8 % of their squares in the worst 1 %
constexpr double least_held_together = 0.98;

// smooth  the height without jumps: parts that are cut off lie where that has them
EdgeAware with_jumps(const NormalMap& normals, const Mask& mask, const Grid<float>& smooth,
                     const IntegrateOptions& options) {
  EdgeAware found = edge_aware_height(
      slopes_of(normals, mask, options.pin_hole, least_facing_at_jumps),
      facing_of(normals, mask, options.pin_hole, least_facing_at_jumps), mask,
      {.weight = options.weight.empty() ? nullptr : &options.weight, .done = options.round_done});
  if (found.held_together < least_held_together) place_parts(found, smooth);
  return found;
}

struct Disagreement {
  double rms = 0.0;             // of the steps of a height and the rises they should have, px
  double share_of_worst = 0.0;  // of the squared curl, in the worst 1 % of all squares of pixels
};

// Non-negative numbers in bins that are 1/128 of their value wide, so that the largest of them are
// found without keeping any.
class Binned {
 public:
  Binned() : count_(bins, 0.0), sum_(bins, 0.0) {}

  void add(float value) {
    const auto bin = std::bit_cast<std::uint32_t>(value) >> 16;
    count_[bin] += 1.0;
    sum_[bin] += value;
  }
  // Of the sum of all, what the largest `share` of them have; 0 if there are none.
  double share_of_largest(double share) const {
    const double total = std::accumulate(sum_.begin(), sum_.end(), 0.0);
    double rest = share * std::accumulate(count_.begin(), count_.end(), 0.0);
    double largest = 0.0;
    for (std::size_t bin = bins; bin-- > 0 && rest > 0.0;) {
      if (count_[bin] == 0.0) continue;
      const double taken = std::min(rest, count_[bin]);
      largest += taken / count_[bin] * sum_[bin];
      rest -= taken;
    }
    return total > 0.0 ? largest / total : 0.0;
  }

 private:
  static constexpr std::size_t bins = 1 << 15;  // the sign of a float is not counted
  std::vector<double> count_;
  std::vector<double> sum_;
};

// Round a square of four pixels the rises of any height add up to 0. Errors of the normals leave a
// little everywhere, a jump leaves much along a line.
//
// weight  of each pixel, or empty: what hardly counts may disagree with all others
Disagreement disagreement(const Grid<float>& height, const SlopeMap& slopes, const Mask& mask,
                          const Grid<float>& weight) {
  const Grid<float> relative = weight.empty() ? weight : with_median_1(weight, mask);
  const auto trust = [&](int row, int col) {
    return relative.empty() ? 1.0f : std::min(1.0f, relative(row, col));
  };
  const auto inside = [&](int row, int col) { return mask.contains(row, col) && mask(row, col); };
  const auto rise_east = [&](int row, int col) {
    return 0.5f * (slopes(row, col).x() + slopes(row, col + 1).x());
  };
  const auto rise_south = [&](int row, int col) {
    return -0.5f * (slopes(row, col).y() + slopes(row + 1, col).y());
  };
  double sum = 0.0;
  double count = 0.0;
  Binned curls;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const auto add = [&](int r, int c, float rise) {
        const double counts = double(std::min(trust(row, col), trust(r, c)));
        sum += counts * std::pow(double(height(r, c)) - height(row, col) - rise, 2);
        count += counts;
      };
      const bool right = inside(row, col + 1);
      const bool below = inside(row + 1, col);
      if (right) add(row, col + 1, rise_east(row, col));
      if (below) add(row + 1, col, rise_south(row, col));
      if (!right || !below || !inside(row + 1, col + 1)) continue;
      const float curl = rise_east(row, col) + rise_south(row, col + 1) - rise_east(row + 1, col) -
                         rise_south(row, col);
      const float counts = std::min(
          {trust(row, col), trust(row, col + 1), trust(row + 1, col), trust(row + 1, col + 1)});
      curls.add(counts * curl * curl);
    }
  }
  return {std::sqrt(sum / std::max(count, 1.0)), curls.share_of_largest(0.01)};
}

}  // namespace

Grid<float> integrate(const NormalMap& normals, const Mask& mask, double pitch,
                      const IntegrateOptions& options) {
  assert(normals.same_size(mask) && pitch > 0.0);
  require_pixels(mask);
  const SlopeMap slopes = slopes_of(normals, mask, options.pin_hole);
  return in_units(height_px(slopes, mask, options), pitch, options.pin_hole);
}

Integrated integrate_with_jumps(const NormalMap& normals, const Mask& mask, double pitch,
                                Jumps jumps, const IntegrateOptions& options) {
  require_pixels(mask);
  const bool too_large = mask.memory() != nullptr;
  if (jumps == Jumps::allowed && too_large) {
    throw Error("jumps cannot be found in a map that is kept on the disk: keep it in memory");
  }
  const SlopeMap slopes = slopes_of(normals, mask, options.pin_hole);
  Grid<float> height = height_px(slopes, mask, options);
  std::string reason = "as asked";
  if (jumps == Jumps::automatic) {
    const Disagreement found = disagreement(height, slopes, mask, options.weight);
    if (found.rms <= least_rms || found.share_of_worst <= least_share) {
      reason = fmt::format(
          "slopes disagree with the height by {:.2g} px rms, and {:.0f} % of their "
          "curl is in 1 % of the pixels: no sign of jumps",
          found.rms, 100.0 * found.share_of_worst);
    } else if (too_large) {
      reason = "there are signs of jumps, but the map is too large to look for them";
    } else {
      jumps = Jumps::allowed;
      reason =
          "the slopes disagree with any smooth height along a few lines: the surface hides parts "
          "of itself there";
    }
  }
  if (jumps != Jumps::allowed) {
    return {in_units(std::move(height), pitch, options.pin_hole), false, reason};
  }
  EdgeAware jumping = with_jumps(normals, mask, height, options);
  if (jumping.held_together < least_held_together) {
    reason += fmt::format(
        "; jumps cut {:.0f} % of it off all around, and how high that lies over the rest is only "
        "known to lie between: it is put where a height without jumps has it",
        100.0 * (1.0 - jumping.held_together));
  }
  return {in_units(std::move(jumping.height), pitch, options.pin_hole), true, reason};
}

Grid<double> integrate_reference(const NormalMap& normals, const Mask& mask, double pitch,
                                 double relative_tolerance) {
  require_pixels(mask);
  Grid<int> unknown(mask.rows(), mask.cols(), -1);
  int unknowns = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) unknown[i] = unknowns++;
  }
  const Equations equations = equations_of(normals, mask, unknown, unknowns);
  const Eigen::SparseMatrix<double> laplacian = equations.matrix.transpose() * equations.matrix;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                           Eigen::IdentityPreconditioner>
      solver(laplacian);
  solver.setTolerance(relative_tolerance);
  solver.setMaxIterations(10 * unknowns + 100);
  Eigen::VectorXd height = solver.solve(equations.matrix.transpose() * equations.rise);
  subtract_region_means(laplacian, height);
  Grid<double> result(mask.rows(), mask.cols(), 0.0);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) result[i] = pitch * height[unknown[i]];
  }
  return result;
}

}  // namespace hada
