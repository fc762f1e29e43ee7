#include "reconstruct/robust_pca.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace hada {
namespace {

using Samples = Eigen::MatrixXf;  // pixels x lights

constexpr float dark_share = 0.05f;  // of a pixel's brightest sample: darker is a shadow, unknown
constexpr int most_rounds = 200;
constexpr float enough = 1e-6f;  // of the norm of the samples: what A + E may leave

Samples samples_of(const Tile& tile, const std::vector<float>& values) {
  return Eigen::Map<const Samples, 0, Eigen::OuterStride<>>(values.data(), tile.pixels, tile.lights,
                                                            Eigen::OuterStride<>(tile.stride));
}

// Singular values above `threshold` are lowered by it, the others become 0.
Samples shrink_singular(const Samples& matrix, double threshold) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(matrix.cols(), matrix.cols());
  constexpr Eigen::Index strip = 512;
  for (Eigen::Index row = 0; row < matrix.rows(); row += strip) {
    const Eigen::MatrixXd part =
        matrix.middleRows(row, std::min(strip, matrix.rows() - row)).cast<double>();
    gram += part.transpose() * part;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  Eigen::VectorXd kept = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  for (double& value : kept) value = value > threshold ? 1.0 - threshold / value : 0.0;
  const Eigen::MatrixXd& basis = solver.eigenvectors();
  return matrix * (basis * kept.asDiagonal() * basis.transpose()).cast<float>();
}

}  // namespace

void fit_robust_pca(Tile& tile) {
  const Samples grey = samples_of(tile, tile.grey);
  Samples trust = samples_of(tile, tile.trust);
  const Eigen::VectorXf dark = dark_share * grey.rowwise().maxCoeff();
  for (int k = 0; k < tile.lights; ++k) {
    trust.col(k) = (grey.col(k).array() > dark.array()).select(trust.col(k), 0.0f);
  }
  const Samples data = (grey.array() * trust.array()).matrix();
  const float lambda = 1.0f / std::sqrt(float(std::max(data.rows(), data.cols())));
  const float norm = data.norm();
  Samples low = Samples::Zero(data.rows(), data.cols());
  Samples error = low;
  if (norm > 0.0f) {
    const double largest = std::sqrt((data.cast<double>().transpose() * data.cast<double>())
                                         .selfadjointView<Eigen::Lower>()
                                         .eigenvalues()
                                         .maxCoeff());
    Samples multiplier =
        data / float(std::max(largest, double(data.cwiseAbs().maxCoeff() / lambda)));
    double mu = 1.25 / largest;
    const double most = 1e7 * mu;
    for (int round = 0; round < most_rounds; ++round) {
      const float step = float(1.0 / mu);
      low = shrink_singular(data - error + step * multiplier, 1.0 / mu);
      const Samples rest = data - low + step * multiplier;
      const float edge = lambda * step;
      // Unknown entries cost nothing: the error takes all of the rest there.
      error =
          (trust.array() > 0.0f)
              .select(rest.array().sign() * (rest.array().abs() - edge).max(0.0f), rest.array());
      const Samples left = data - low - error;
      multiplier += float(mu) * left;
      if (left.norm() < enough * norm) break;
      mu = std::min(1.5 * mu, most);
    }
  }
  Eigen::MatrixX3d directions(tile.lights, 3);
  for (int i = 0; i < tile.pixels; ++i) {
    if (i == 0 || tile.near) {
      for (int k = 0; k < tile.lights; ++k) {
        const std::size_t j = tile.near ? tile.at(k, i) : std::size_t(k);
        directions.row(k) << tile.x_to[j], tile.y_to[j], tile.z_to[j];
      }
    }
    const Eigen::Vector3d found =
        (directions.transpose() * directions)
            .ldlt()
            .solve(directions.transpose() * low.row(i).cast<double>().transpose());
    tile.x[std::size_t(i)] = float(found.x());
    tile.y[std::size_t(i)] = float(found.y());
    tile.z[std::size_t(i)] = float(found.z());
    for (int k = 0; k < tile.lights; ++k) {
      tile.weight[tile.at(k, i)] = trust(i, k) > 0.0f && error(i, k) == 0.0f ? 1.0f : 0.0f;
    }
  }
}

}  // namespace hada
