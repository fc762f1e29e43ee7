#include "reconstruct/prior_heights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/regions.h"

namespace hada {
namespace {

// Along a direction in which known pixels spread by less than this, rms in pixels, they are spots
// in a line, which say nothing of the tilt across it.
constexpr double least_spread_px = 4.0;
// Waves of more than this many times the map are all alike in it.
constexpr double longest_cutoff = 100.0;
// Up to this many standard deviations from the last known pixel the smooth rest is what is known
// there; beyond, it fades.
constexpr double reach = 3.0;

// Sums of one, of the place (x, y) and of a value v, and of their products.
struct Moments {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

  void add(double x, double y, double v) {
    const Eigen::Vector3d all(x, y, v);
    count += 1.0;
    sum += all;
    products.noalias() += all * all.transpose();
  }
  void add(const Moments& other) {
    count += other.count;
    sum += other.sum;
    products += other.products;
  }
  Eigen::Vector3d mean() const { return sum / count; }
  Eigen::Matrix3d spread() const { return products - sum * sum.transpose() / count; }
};

// An offset for each region, and a tilt that all share.
struct Tilted {
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  // per pixel to the right, and down
  std::vector<double> offset;                      // of regions, as numbered

  double at(int row, int col, int region) const {
    return offset[std::size_t(region)] + tilt.x() * col + tilt.y() * row;
  }
};

// work(col, difference) for the pixels of a run where the prior is known.
template <class Work>
void for_known(const PriorHeights& prior, const Grid<float>& height, int row,
               const Regions::Run& run, const Work& work) {
  for (int col = run.first; col < run.last; ++col) {
    const float known = prior.height(row, col);
    if (std::isfinite(known)) work(col, double(known) - height(row, col));
  }
}

Tilted tilted_difference(const PriorHeights& prior, const Grid<float>& height,
                         const Regions& regions) {
  // By runs first, so that sums do not depend on the number of threads.
  std::vector<Moments> of_runs(regions.runs.size());
  for_each_index(height.rows(), [&](int row) {
    for (std::size_t run = regions.starts[std::size_t(row)];
         run < regions.starts[std::size_t(row) + 1]; ++run) {
      for_known(prior, height, row, regions.runs[run],
                [&](int col, double d) { of_runs[run].add(col, row, d); });
    }
  });
  std::vector<Moments> of_regions(regions.size.size());
  for (std::size_t run = 0; run < of_runs.size(); ++run) {
    of_regions[std::size_t(regions.runs[run].region)].add(of_runs[run]);
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Moments all;
  for (const Moments& region : of_regions) {
    if (region.count > 0.0) spread += region.spread();
    all.add(region);
  }
  if (all.count == 0.0) {
    throw Error(
        "the prior knows the height of no pixel of the mask; check that both show the same "
        "part of the surface");
  }
  Tilted found;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread.topLeftCorner<2, 2>());
  for (int k = 0; k < 2; ++k) {
    const double squares = axes.eigenvalues()[k];
    if (squares < least_spread_px * least_spread_px * all.count) continue;
    const Eigen::Vector2d axis = axes.eigenvectors().col(k);
    found.tilt += axis.dot(spread.topRightCorner<2, 1>()) / squares * axis;
  }
  const auto offset_of = [&](const Moments& moments) {
    const Eigen::Vector3d mean = moments.mean();
    return mean.z() - found.tilt.dot(mean.head<2>());
  };
  for (const Moments& region : of_regions) {
    found.offset.push_back(offset_of(region.count > 0.0 ? region : all));
  }
  return found;
}

// Sums over blocks of pixels, and how many pixels were known, both smoothed alike.
class SmoothRest {
 public:
  SmoothRest(const PriorHeights& prior, const Grid<float>& height, const Regions& regions,
             const Tilted& tilted) {
    // Half of a wave of the cutoff is let through: exp(-2 pi^2 sigma^2 / cutoff^2) = 1 / 2.
    const double cutoff =
        std::min(prior.cutoff_px, longest_cutoff * std::max(height.rows(), height.cols()));
    const double sigma = cutoff * std::sqrt(0.5 * std::numbers::ln2) / std::numbers::pi;
    block_ = std::max(int(sigma / 4.0), 1);
    // Of one known pixel, `reach` away.
    least_weight_ = std::exp(-0.5 * reach * reach) / (2.0 * std::numbers::pi * sigma * sigma);
    sum_ = Grid<double>((height.rows() + block_ - 1) / block_,
                        (height.cols() + block_ - 1) / block_, 0.0, height.memory());
    weight_ = sum_;
    for_each_index(sum_.rows(), [&](int lattice_row) {
      const int end = std::min((lattice_row + 1) * block_, height.rows());
      for (int row = lattice_row * block_; row < end; ++row) {
        for (const Regions::Run& run : regions.row(row)) {
          for_known(prior, height, row, run, [&](int col, double d) {
            sum_(lattice_row, col / block_) += d - tilted.at(row, col, run.region);
            weight_(lattice_row, col / block_) += 1.0;
          });
        }
      }
    });
    // Gathering in blocks and joining their middles by lines smooth too: variances of b^2 / 12 and
    // b^2 / 6.
    const double left = std::max(sigma * sigma - 0.25 * block_ * block_, 0.0);
    smooth(sum_, std::sqrt(left) / block_);
    smooth(weight_, std::sqrt(left) / block_);
    // Sums of blocks, spread over their pixels.
    for (Grid<double>* grid : {&sum_, &weight_}) {
      for (double& value : *grid) value /= double(block_) * block_;
    }
  }

  double at(int row, int col) const {
    const auto [r, down] = place(row, sum_.rows());
    const auto [c, right] = place(col, sum_.cols());
    const auto joined = [&, r = r, c = c, down = down, right = right](const Grid<double>& grid) {
      const int below = std::min(r + 1, grid.rows() - 1);
      const int beside = std::min(c + 1, grid.cols() - 1);
      return (1.0 - down) * ((1.0 - right) * grid(r, c) + right * grid(r, beside)) +
             down * ((1.0 - right) * grid(below, c) + right * grid(below, beside));
    };
    return joined(sum_) / std::max(joined(weight_), least_weight_);
  }

 private:
  struct Place {
    int index;     // of the block whose middle lies before
    double share;  // of the way to the next one
  };
  Place place(int pixel, int blocks) const {
    const double at = std::clamp((pixel + 0.5) / block_ - 0.5, 0.0, double(blocks - 1));
    return {int(at), at - int(at)};
  }

  static void smooth(Grid<double>& grid, double sigma) {
    const int radius = int(std::ceil(4.0 * sigma));
    std::vector<double> kernel;
    double total = 0.0;
    for (int i = -radius; i <= radius; ++i) {
      kernel.push_back(sigma > 0.0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : 1.0);
      total += kernel.back();
    }
    for (double& weight : kernel) weight /= total;
    for (const bool across : {true, false}) {
      Grid<double> smoothed(grid.rows(), grid.cols(), 0.0, grid.memory());
      const int length = across ? grid.cols() : grid.rows();
      for_each_index(grid.rows(), [&](int row) {
        for (int col = 0; col < grid.cols(); ++col) {
          const int here = across ? col : row;
          double sum = 0.0;
          for (int i = std::max(here - radius, 0); i <= std::min(here + radius, length - 1); ++i) {
            sum += kernel[std::size_t(i - here + radius)] * (across ? grid(row, i) : grid(i, col));
          }
          smoothed(row, col) = sum;
        }
      });
      grid = std::move(smoothed);
    }
  }

  int block_ = 1;
  double least_weight_ = 0.0;
  Grid<double> sum_, weight_;
};

}  // namespace

PriorHeights PriorHeights::zeros_of_cells(int factor) const {
  PriorHeights cells;
  cells.cutoff_px = cutoff_px / factor;
  cells.height = Grid<float>((height.rows() + factor - 1) / factor,
                             (height.cols() + factor - 1) / factor, std::nanf(""));
  for_each_index(cells.height.rows(), [&](int cell_row) {
    for (int row = cell_row * factor; row < std::min((cell_row + 1) * factor, height.rows());
         ++row) {
      for (int col = 0; col < height.cols(); ++col) {
        if (std::isfinite(height(row, col))) cells.height(cell_row, col / factor) = 0.0f;
      }
    }
  });
  return cells;
}

void level(Grid<float>& height, const Mask& mask, const PriorHeights& prior) {
  assert(height.same_size(mask) && height.same_size(prior.height));
  const Regions regions = regions_of(mask);
  const Tilted tilted = tilted_difference(prior, height, regions);
  const SmoothRest rest(prior, height, regions, tilted);
  std::vector<double> sums(std::size_t(height.rows()));
  for_each_index(height.rows(), [&](int row) {
    int col = 0;
    const auto leave_out = [&](int end) {
      for (; col < end; ++col) height(row, col) = 0.0f;
    };
    for (const Regions::Run& run : regions.row(row)) {
      leave_out(run.first);
      for (; col < run.last; ++col) {
        height(row, col) =
            float(height(row, col) + tilted.at(row, col, run.region) + rest.at(row, col));
        sums[std::size_t(row)] += height(row, col);
      }
    }
    leave_out(height.cols());
  });
  double mean = 0.0;
  for (const double sum : sums) mean += sum;
  mean /= double(mask.size()) - regions.size[0];
  for_each_index(height.rows(), [&](int row) {
    for (const Regions::Run& run : regions.row(row)) {
      for (int col = run.first; col < run.last; ++col) height(row, col) -= float(mean);
    }
  });
}

}  // namespace hada
