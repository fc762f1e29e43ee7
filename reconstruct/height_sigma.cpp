#include "reconstruct/height_sigma.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/box_sum.h"
#include "reconstruct/edges.h"
#include "reconstruct/slope_solver.h"

namespace hada {
namespace {

constexpr int draws = 32;
constexpr int coarse_draws = 512;
constexpr int groups = 8;         // of draws: threads that are of use
constexpr int coarse_factor = 4;  // between both lattices
constexpr int smoothing_px = 6;
constexpr double most_cells = 250000.0;
constexpr Seed seed =
    0x5153;  // the same draws for everybody: the result is a function of its input

// The covariance of the slopes (dz/dx, dz/dy) of a normal with this sigma along its tangents.
Eigen::Matrix2d slope_covariance(const Eigen::Vector3f& normal, double sigma) {
  const Eigen::Vector3d n = normal.cast<double>();
  // d(-nx/nz, -ny/nz)/dn; the normal itself is in its null space, so no tangent basis is needed.
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << -1.0, 0.0, n.x() / n.z(), 0.0, -1.0, n.y() / n.z();
  jacobian *= sigma / n.z();
  return jacobian * jacobian.transpose();
}

// Slope errors on a lattice of square cells of `factor` pixels.
struct Lattice {
  Mask mask;                          // cells with at least one pixel
  Grid<float> counts;                 // sum of the weights of the pixels of a cell
  std::optional<Grid<float>> weight;  // of a cell: the mean of those, where they have any
  Grid<Eigen::Matrix2f> root;         // Cholesky factor of the covariance of the mean slope
  Grid<float> variance_left_out_px;   // of the height, in octaves finer than the lattice, px^2
  std::optional<PriorHeights> prior;  // of errors: 0 where the height is known

  // of_pixels: their weights, or null
  Lattice(const NormalMap& normals, const Grid<float>& normal_sigma, const Mask& inside, int factor,
          const PriorHeights* known, const Grid<float>* of_pixels)
      : mask((inside.rows() + factor - 1) / factor, (inside.cols() + factor - 1) / factor, 0),
        counts(mask.rows(), mask.cols()),
        root(mask.rows(), mask.cols(), Eigen::Matrix2f::Zero()),
        variance_left_out_px(mask.rows(), mask.cols()) {
    if (known) prior = known->zeros_of_cells(factor);
    if (of_pixels) weight.emplace(mask.rows(), mask.cols(), 1.0f);
    for_each_index(mask.rows(), [&](int row) {
      for (int col = 0; col < mask.cols(); ++col) {
        Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
        double pixels = 0.0;
        double count = 0.0;
        for (int r = row * factor; r < std::min((row + 1) * factor, inside.rows()); ++r) {
          for (int c = col * factor; c < std::min((col + 1) * factor, inside.cols()); ++c) {
            if (!inside(r, c)) continue;
            const double counts_as = of_pixels ? double((*of_pixels)(r, c)) : 1.0;
            sum += counts_as * counts_as * slope_covariance(normals(r, c), normal_sigma(r, c));
            count += counts_as;
            pixels += 1.0;
          }
        }
        if (pixels == 0.0) continue;
        mask(row, col) = 1;
        counts(row, col) = float(count);
        if (weight) (*weight)(row, col) = float(count / pixels);
        const Eigen::Matrix2d mean = sum / (count * count);
        const double first = std::sqrt(mean(0, 0));
        const double mixed = first > 0.0 ? mean(1, 0) / first : 0.0;
        const double second = std::sqrt(std::max(mean(1, 1) - mixed * mixed, 0.0));
        root(row, col) << float(first), 0.0f, float(mixed), float(second);
        // White slopes of variance v give a height of power v / k^2: v ln(k2 / k1) / (2 pi)
        // between two frequencies, whatever the direction.
        variance_left_out_px(row, col) =
            float(0.5 * pixels * mean.trace() * std::log(factor) / (2.0 * std::numbers::pi));
      }
    });
  }
};

// One draw of the slope errors. Their shape is free, as only their variance survives the sum over
// many pixels; so they are uniform, two from the halves of one hash.
SlopeMap drawn_slopes(const Lattice& lattice, int draw) {
  const double width = std::sqrt(12.0);  // of the uniform distribution of variance 1
  const auto centred = [width](std::uint32_t bits) {
    return float(((double(bits) + 0.5) * 0x1p-32 - 0.5) * width);
  };
  SlopeMap slopes(lattice.mask.rows(), lattice.mask.cols(), Eigen::Vector2f::Zero());
  for_each_index(lattice.mask.rows(), [&](int row) {
    for (int col = 0; col < lattice.mask.cols(); ++col) {
      if (!lattice.mask(row, col)) continue;
      const std::uint64_t bits = hash(seed, row, col, draw);
      const Eigen::Vector2f pair(centred(std::uint32_t(bits)), centred(std::uint32_t(bits >> 32)));
      slopes(row, col) = lattice.root(row, col) * pair;
    }
  });
  return slopes;
}

// The mean over the neighbourhood, of the pixels of the mask only.
Grid<float> smoothed(Grid<float> values, const Mask& mask) {
  Grid<float> inside(mask.rows(), mask.cols());
  std::copy(mask.begin(), mask.end(), inside.begin());
  const Grid<float> count = box_sum(inside, smoothing_px);
  Grid<float> sum = box_sum(values, smoothing_px);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    values[i] = mask[i] ? sum[i] / count[i] : 0.0f;
  }
  return values;
}

// The slopes of a lattice as the cells of a coarser one see them.
SlopeMap means(const SlopeMap& slopes, const Lattice& lattice, const Lattice& coarse) {
  SlopeMap result(coarse.mask.rows(), coarse.mask.cols(), Eigen::Vector2f::Zero());
  for_each_index(coarse.mask.rows(), [&](int row) {
    const int end = std::min((row + 1) * coarse_factor, slopes.rows());
    for (int r = row * coarse_factor; r < end; ++r) {
      for (int c = 0; c < slopes.cols(); ++c) {
        result(row, c / coarse_factor) += lattice.counts(r, c) * slopes(r, c);
      }
    }
    for (int col = 0; col < coarse.mask.cols(); ++col) {
      if (coarse.mask(row, col)) result(row, col) /= coarse.counts(row, col);
    }
  });
  return result;
}

// Heights that slope errors on a lattice make, in cells.
class DrawnHeights {
 public:
  DrawnHeights(const Lattice& lattice, Levelling levelling)
      : lattice_(lattice),
        levelling_(levelling),
        solver_(lattice.mask,
                lattice.weight ? std::optional(edge_weights(*lattice.weight)) : std::nullopt) {
    // A hundredth of the slope errors: heights err by more than they do.
    double squares = 0.0;
    for (const auto& root : lattice.root) squares += double(root.squaredNorm());
    const double cells =
        double(std::count(lattice.mask.begin(), lattice.mask.end(), std::uint8_t(1)));
    tolerance_ = 0.01 * std::sqrt(0.5 * squares / std::max(cells, 1.0));
  }

  Grid<float> squares(const SlopeMap& slopes) {
    Grid<float> error = solver_.height(slopes, tolerance_, 100);
    if (lattice_.prior) {
      level(error, lattice_.mask, *lattice_.prior);
    } else {
      level(error, lattice_.mask, levelling_);
    }
    for (float& value : error) value *= value;
    return error;
  }

 private:
  const Lattice& lattice_;
  Levelling levelling_;
  SlopeSolver solver_;
  double tolerance_ = 0.0;
};

using Maps = std::vector<Grid<float>>;

// The means over draws of the maps that `make()` gives: a function of the draw, with solvers of its
// own. Groups of draws are added up apart, so that the sum is the same for any number of threads.
template <class Make>
Maps means_of_draws(int first, int count, const Make& make) {
  const auto add = [](const Maps& maps, Maps& sums) {
    for (std::size_t m = 0; m < sums.size(); ++m) {
      for (std::size_t i = 0; i < sums[m].size(); ++i) sums[m][i] += maps[m][i];
    }
  };
  std::vector<Maps> sums(groups);
  for_each_index(groups, [&](int group) {
    auto maps_of = make();
    Maps& sum = sums[std::size_t(group)] = maps_of(first + group);
    for (int draw = group + groups; draw < count; draw += groups) add(maps_of(first + draw), sum);
  });
  Maps means = std::move(sums.front());
  for (std::size_t group = 1; group < groups; ++group) add(sums[group], means);
  for (auto& mean : means) {
    for (float& value : mean) value /= float(count);
  }
  return means;
}

// The variance of the height on a lattice, in cells^2. Long waves make most of it and differ most
// from draw to draw, so that it takes many; those are had on a coarse lattice. What that does not
// see takes few draws, which both lattices share.
Grid<float> drawn_variance(const Lattice& lattice, const Lattice& coarse, Levelling levelling) {
  constexpr float scale = coarse_factor * coarse_factor;  // of the squares of a cell
  const auto of_coarse = [](const Grid<float>& grid, int row, int col) {
    return scale * grid(row / coarse_factor, col / coarse_factor);
  };
  const Maps far = means_of_draws(draws, coarse_draws, [&] {
    return [&, heights = DrawnHeights(coarse, levelling)](int draw) mutable {
      return Maps{heights.squares(drawn_slopes(coarse, draw))};
    };
  });
  Maps near = means_of_draws(0, draws, [&] {
    return [&, heights = DrawnHeights(lattice, levelling),
            coarse_heights = DrawnHeights(coarse, levelling)](int draw) mutable {
      const SlopeMap slopes = drawn_slopes(lattice, draw);
      const Grid<float> squares = heights.squares(slopes);
      return Maps{squares, coarse_heights.squares(means(slopes, lattice, coarse))};
    };
  });
  const Grid<float> few = smoothed(near.front(), lattice.mask);
  Grid<float> variance = std::move(near.front());
  for (int row = 0; row < variance.rows(); ++row) {
    for (int col = 0; col < variance.cols(); ++col) {
      float& here = variance(row, col);
      const float beyond = of_coarse(far[0], row, col) - of_coarse(near[1], row, col);
      here = lattice.mask(row, col) ? here + beyond : 0.0f;
    }
  }
  variance = smoothed(std::move(variance), lattice.mask);
  // Where the coarse lattice joins what is torn it is another surface: then the few draws, which
  // know a variance to a quarter, say that it is not so.
  for (std::size_t i = 0; i < variance.size(); ++i) {
    variance[i] = std::clamp(variance[i], 0.5f * few[i], 2.0f * few[i]);
  }
  return variance;
}

}  // namespace

Grid<float> height_sigma(const NormalMap& normals, const Grid<float>& normal_sigma,
                         const Mask& mask, double pitch, Levelling levelling,
                         const PriorHeights* prior, const Grid<float>* weight) {
  int factor = 1;
  const auto pixels =
      double(std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; }));
  while (pixels / (double(factor) * factor) > most_cells) factor *= 2;
  const Lattice lattice(normals, normal_sigma, mask, factor, prior, weight);

  const Lattice coarse(normals, normal_sigma, mask, coarse_factor * factor, prior, weight);
  const Grid<float> variance = drawn_variance(lattice, coarse, levelling);

  Grid<float> sigma(mask.rows(), mask.cols());
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const int r = row / factor;
      const int c = col / factor;
      const double drawn = double(variance(r, c)) * factor * factor;
      sigma(row, col) = float(pitch * std::sqrt(drawn + lattice.variance_left_out_px(r, c)));
    }
  });
  return sigma;
}

}  // namespace hada
