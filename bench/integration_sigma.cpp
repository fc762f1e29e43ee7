#include <cmath>

#include "bench/integration_study.h"
#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/height_sigma.h"
#include "reconstruct/integrate.h"

namespace hada {
namespace {

constexpr Seed seed = 29;  // another than that of the draws of `height_sigma`
constexpr int draws = 200;

NormalMap normals_of(const SlopeMap& slopes) {
  NormalMap normals(slopes.rows(), slopes.cols(), Eigen::Vector3f::UnitZ());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    normals[i] = Eigen::Vector3f(-slopes[i].x(), -slopes[i].y(), 1.0f).normalized();
  }
  return normals;
}

// The normals with errors of their own along both tangent axes.
NormalMap drawn(const NormalMap& normals, const Grid<float>& sigma, int draw) {
  NormalMap result = normals;
  for_each_index(normals.rows(), [&](int row) {
    for (int col = 0; col < normals.cols(); ++col) {
      const Eigen::Vector3f& normal = normals(row, col);
      const Eigen::Vector3f across = normal.unitOrthogonal();
      const auto error = [&](int axis) {
        return sigma(row, col) * float(gaussian(seed, row, col, 2 * draw + axis));
      };
      result(row, col) =
          (normal + error(0) * across + error(1) * normal.cross(across)).normalized();
    }
  });
  return result;
}

}  // namespace

double share_of_good_sigmas(int size) {
  const IntegrationScene scene = integration_scene(MaskKind::irregular, size);
  const NormalMap normals = normals_of(scene.slopes);
  Grid<float> normal_sigma(size, size, 0.01f);
  for (int row = 0; row < size; ++row) {
    for (int col = size / 2; col < size; ++col) normal_sigma(row, col) = 0.02f;
  }
  const auto levelled = [&](const NormalMap& of) {
    Grid<float> height = integrate(of, scene.mask, 1.0);
    level(height, scene.mask, Levelling::plane);
    return height;
  };
  const Grid<float> height = levelled(normals);
  // Spread about the mean of the draws: noise of sigma also stretches slopes by sigma^2 / nz^2,
  // here by one part in two thousand, which is no spread, but would count at 800 pixels.
  Grid<double> mean(size, size), squares(size, size);
  for (int draw = 0; draw < draws; ++draw) {
    const Grid<float> other = levelled(drawn(normals, normal_sigma, draw));
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double off = double(other[i]) - height[i];
      mean[i] += off / draws;
      squares[i] += off * off;
    }
  }
  const Grid<float> sigma = height_sigma(normals, normal_sigma, scene.mask, 1.0, Levelling::plane);
  double inside = 0.0;
  double good = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (!scene.mask[i]) continue;
    const double spread = std::sqrt(squares[i] / draws - mean[i] * mean[i]);
    inside += 1.0;
    good += std::abs(sigma[i] - spread) <= 0.15 * spread;
  }
  return good / inside;
}

}  // namespace hada
