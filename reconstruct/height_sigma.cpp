#include "reconstruct/height_sigma.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Core>

#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/box_sum.h"
#include "reconstruct/slope_solver.h"

namespace hada {
namespace {

constexpr int draws = 64;
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
  Mask mask;                         // cells with at least one pixel
  Grid<Eigen::Matrix2f> root;        // Cholesky factor of the covariance of the mean slope
  Grid<float> variance_left_out_px;  // of the height, in octaves finer than the lattice, px^2

  Lattice(const NormalMap& normals, const Grid<float>& normal_sigma, const Mask& pixels, int factor)
      : mask((pixels.rows() + factor - 1) / factor, (pixels.cols() + factor - 1) / factor, 0),
        root(mask.rows(), mask.cols(), Eigen::Matrix2f::Zero()),
        variance_left_out_px(mask.rows(), mask.cols()) {
    for_each_index(mask.rows(), [&](int row) {
      for (int col = 0; col < mask.cols(); ++col) {
        Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
        double count = 0.0;
        for (int r = row * factor; r < std::min((row + 1) * factor, pixels.rows()); ++r) {
          for (int c = col * factor; c < std::min((col + 1) * factor, pixels.cols()); ++c) {
            if (!pixels(r, c)) continue;
            sum += slope_covariance(normals(r, c), normal_sigma(r, c));
            count += 1.0;
          }
        }
        if (count == 0.0) continue;
        mask(row, col) = 1;
        const Eigen::Matrix2d mean = sum / (count * count);
        const double first = std::sqrt(mean(0, 0));
        const double mixed = first > 0.0 ? mean(1, 0) / first : 0.0;
        const double second = std::sqrt(std::max(mean(1, 1) - mixed * mixed, 0.0));
        root(row, col) << float(first), 0.0f, float(mixed), float(second);
        // White slopes of variance v give a height of power v / k^2: v ln(k2 / k1) / (2 pi)
        // between two frequencies, whatever the direction.
        variance_left_out_px(row, col) =
            float(0.5 * sum.trace() / count * std::log(factor) / (2.0 * std::numbers::pi));
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

}  // namespace

Grid<float> height_sigma(const NormalMap& normals, const Grid<float>& normal_sigma,
                         const Mask& mask, double pitch, Levelling levelling) {
  int factor = 1;
  const auto pixels =
      double(std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; }));
  while (pixels / (double(factor) * factor) > most_cells) factor *= 2;
  const Lattice lattice(normals, normal_sigma, mask, factor);

  // A hundredth of the slope errors, in px: heights err by more than they do.
  double squares = 0.0;
  for (const auto& root : lattice.root) squares += double(root.squaredNorm());
  const double cells =
      double(std::count(lattice.mask.begin(), lattice.mask.end(), std::uint8_t(1)));
  const double tolerance_px = 0.01 * std::sqrt(0.5 * squares / std::max(cells, 1.0));

  SlopeSolver solver(lattice.mask);
  Grid<float> variance_px(lattice.mask.rows(), lattice.mask.cols());
  for (int draw = 0; draw < draws; ++draw) {
    Grid<float> error = solver.height(drawn_slopes(lattice, draw), tolerance_px, 100);
    level(error, lattice.mask, levelling);
    for (std::size_t i = 0; i < error.size(); ++i) variance_px[i] += error[i] * error[i] / draws;
  }
  variance_px = smoothed(std::move(variance_px), lattice.mask);

  Grid<float> sigma(mask.rows(), mask.cols());
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const int r = row / factor;
      const int c = col / factor;
      const double drawn = double(variance_px(r, c)) * factor * factor;
      sigma(row, col) = float(pitch * std::sqrt(drawn + lattice.variance_left_out_px(r, c)));
    }
  });
  return sigma;
}

}  // namespace hada
