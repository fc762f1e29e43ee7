#include "reconstruct/shared_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace hada {
namespace {

constexpr int curve_terms = 3;
constexpr int common_terms = 4;  // the curve and the bounce, then three for each light
// What the model lacks hangs together over the surface: so many pixels speak for themselves, and
// the sigma of the lights holds against no more.
constexpr double independent_pixels = 400.0;
constexpr double least_sigma = 0.003;  // of a sample, over the albedo: no model is better

Eigen::Vector3d to_light(const Tile& tile, int light, int pixel) {
  const std::size_t i = tile.near ? tile.at(light, pixel) : std::size_t(light);
  return {tile.x_to[i], tile.y_to[i], tile.z_to[i]};
}

// What the error d of a light adds to a sample, over d; see `SharedTerms`.
Eigen::Vector3d off_column(const Tile& tile, int light, int pixel, const Eigen::Vector3d& found) {
  if (!tile.near) return found;
  const Eigen::Vector3d l = to_light(tile, light, pixel);
  return tile.closeness[tile.at(light, pixel)] * (found - 3.0 * l.dot(found) * l);
}

// The normal equations of the shared terms, those of the pixels eliminated.
struct Reduced {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  double squares = 0.0;
  double freedom = 0.0;

  explicit Reduced(int terms)
      : matrix(Eigen::MatrixXd::Zero(terms, terms)), right(Eigen::VectorXd::Zero(terms)) {}
};

// Room for one pixel.
struct Pixel {
  Eigen::Matrix3d own;
  Eigen::Vector3d own_right;
  Eigen::Matrix3Xd mixed;

  explicit Pixel(int terms) : mixed(3, terms) {}
};

void add(const Tile& tile, int i, const SharedModel& model, Pixel& pixel, Reduced& sums) {
  const auto at = std::size_t(i);
  const Eigen::Vector3d found(tile.x[at], tile.y[at], tile.z[at]);
  const double rho = found.norm();
  if (!(rho > 0.0)) return;
  double counted = -3.0;
  double left = 0.0;
  for (int k = 0; k < tile.lights; ++k) {
    const double r = tile.grey[tile.at(k, i)] - found.dot(to_light(tile, k, i));
    counted += tile.weight[tile.at(k, i)];
    left += tile.weight[tile.at(k, i)] * r * r;
  }
  if (counted < 1.0) return;
  // Pixels weigh by what their present fit leaves over, and none more than the model deserves.
  const double scale = 1.0 / (left / counted + std::pow(least_sigma * rho, 2));
  pixel.own.setZero();
  pixel.own_right.setZero();
  pixel.mixed.setZero();
  for (int k = 0; k < tile.lights; ++k) {
    const double weight = scale * tile.weight[tile.at(k, i)];
    if (weight == 0.0) continue;
    const Eigen::Vector3d l = to_light(tile, k, i);
    const double value = tile.raw[tile.at(k, i)];
    Eigen::Vector4d common = Eigen::Vector4d::Zero();
    if (model.curve) {
      const double cosine = std::max(0.0, found.dot(l)) / rho;
      const double away = 1.0 - cosine;
      common.head<curve_terms>() << away, away * away, away * away * away;
      common.head<curve_terms>() *= rho * cosine;
    }
    if (model.bounce) common[curve_terms] = tile.bounce[tile.at(k, i)];
    const Eigen::Vector3d off = off_column(tile, k, i, found);
    const int light = common_terms + 3 * k;
    pixel.own += weight * l * l.transpose();
    pixel.own_right += weight * value * l;
    pixel.mixed.leftCols<common_terms>() += weight * l * common.transpose();
    pixel.mixed.middleCols<3>(light) += weight * l * off.transpose();
    sums.matrix.topLeftCorner<common_terms, common_terms>() += weight * common * common.transpose();
    sums.matrix.block<common_terms, 3>(0, light) += weight * common * off.transpose();
    sums.matrix.block<3, 3>(light, light) += weight * off * off.transpose();
    sums.right.head<common_terms>() += weight * value * common;
    sums.right.segment<3>(light) += weight * value * off;
    sums.squares += weight * value * value;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(pixel.own);
  const Eigen::Matrix3Xd solved = solver.solve(pixel.mixed);
  const Eigen::Vector3d own = solver.solve(pixel.own_right);
  sums.matrix.triangularView<Eigen::Upper>() -= pixel.mixed.transpose() * solved;
  sums.right -= solved.transpose() * pixel.own_right;
  sums.squares -= own.dot(pixel.own_right);
  sums.freedom += counted;
}

}  // namespace

SharedFit fit_shared_terms(const Tile& tile, const SharedModel& model) {
  const int terms = common_terms + 3 * tile.lights;
  Reduced sums(terms);
  Pixel pixel(terms);
  for (int i = 0; i < tile.pixels; ++i) add(tile, i, model, pixel, sums);
  for (int j = 0; j < common_terms; ++j) {
    const bool wanted = j < curve_terms ? model.curve : model.bounce;
    sums.matrix(j, j) += wanted ? 1e-6 * sums.matrix(j, j) + 1e-12 : 1.0;
  }
  for (int j = common_terms; j < terms; ++j) {
    const double sigma = model.light_sigma[std::size_t((j - common_terms) / 3)];
    sums.matrix(j, j) += std::max(1.0, tile.pixels / independent_pixels) / (sigma * sigma);
  }
  const Eigen::VectorXd found =
      sums.matrix.selfadjointView<Eigen::Upper>().ldlt().solve(sums.right);
  SharedFit fit;
  for (int j = 0; j < curve_terms; ++j) fit.terms.curve[j] = model.curve ? float(found[j]) : 0.0f;
  fit.terms.bounce = model.bounce ? float(found[curve_terms]) : 0.0f;
  for (int j = common_terms; j < terms; ++j) fit.terms.off.push_back(float(found[j]));
  fit.freedom = sums.freedom;
  if (sums.freedom > 0.0) fit.misfit = (sums.squares - found.dot(sums.right)) / sums.freedom;
  return fit;
}

}  // namespace hada
