#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "capture/sphere_geometry.h"
#include "core/light_stack.h"

/// What each kind of evidence says of a light, as Ceres wants it. Included by sources only.
///
/// The blocks of unknowns: a light is its direction [3, unit], the logarithm of its strength [1]
/// and its inverse distance [1]; a sphere is its place on the table and its radius [3]; the table
/// has a height below the sheet [1]; a matte sphere also has the logarithm of its value where a
/// light of strength 1 meets it squarely, and its reflectance for light thrown by the surroundings
/// [2]; a pixel of the sheet is albedo times normal and its height [4]; all of the sheet shows the
/// same ambient light [1].
namespace hada {

template <class T>
Eigen::Matrix<T, 3, 1> vector_of(const T* values) {
  return {values[0], values[1], values[2]};
}

/// The centre of a sphere (x, y, radius) that rests on a table at this height.
template <class T>
Eigen::Matrix<T, 3, 1> center_of(const T* sphere, const T& table) {
  return {sphere[0], sphere[1], table + sphere[2]};
}

/// Two unit vectors across a direction.
inline Eigen::Matrix<double, 2, 3> across(const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 2, 3> axes;
  axes.row(0) = direction.unitOrthogonal();
  axes.row(1) = direction.cross(axes.row(0).transpose());
  return axes;
}

/// A square of pixels on a matte sphere: max(0, n.L) + ambient + what the surroundings throw.
struct MatteCost {
  Ray ray;
  Eigen::Vector3d bend;
  double value;
  double thrown;
  const double* ambient;  // may change between two descents
  const double* sigma;

  template <class T>
  bool operator()(const T* direction, const T* log_strength, const T* inverse_distance,
                  const T* table, const T* sphere, const T* surface, T* residual) const {
    using std::exp;
    residual[0] = T(0.0);
    const auto hit = first_hit<T>(ray, center_of(sphere, *table), sphere[2]);
    if (!hit) return true;
    const auto light = arriving<T>(vector_of(direction), *inverse_distance, hit->point);
    const T cosine = (hit->normal + bend.cast<T>()).dot(light);
    T model = *ambient + surface[1] * thrown;
    if (cosine > T(0.0)) model += exp(*log_strength + surface[0]) * cosine;
    residual[0] = (value - model) / *sigma;
    return true;
  }
};

/// A highlight on a chrome sphere: the mirrored ray leads to the light.
struct ChromeCost {
  Ray ray;
  Eigen::Vector3d offset;
  Eigen::Matrix<double, 2, 3> axes;  // across the light's direction
  const double* sigma;

  template <class T>
  bool operator()(const T* direction, const T* inverse_distance, const T* table, const T* sphere,
                  T* residuals) const {
    residuals[0] = residuals[1] = T(0.0);
    const auto seen = mirrored<T>(ray, center_of(sphere, *table), sphere[2]);
    if (!seen) return true;
    const auto light = arriving<T>(vector_of(direction), *inverse_distance, seen->point);
    const Eigen::Matrix<T, 3, 1> off = seen->direction + offset.cast<T>() - light.normalized();
    const Eigen::Matrix<T, 2, 1> miss = axes.cast<T>() * off / T(*sigma);
    residuals[0] = miss[0];
    residuals[1] = miss[1];
    return true;
  }
};

/// A pixel of the sheet: g.L + ambient for g = albedo times normal. How high it lies matters to
/// near lamps.
struct SheetCost {
  Eigen::Vector3d point;
  double value;
  const double* sigma;

  template <class T>
  bool operator()(const T* direction, const T* log_strength, const T* inverse_distance,
                  const T* ambient, const T* pixel, T* residual) const {
    using std::exp;
    const Eigen::Matrix<T, 3, 1> place(T(point.x()), T(point.y()), pixel[3]);
    const auto light = arriving<T>(vector_of(direction), *inverse_distance, place);
    residual[0] = (value - *ambient - exp(*log_strength) * vector_of(pixel).dot(light)) / *sigma;
    return true;
  }
};

/// The height of a pixel of the sheet, about which nothing is known but that the sheet is flat.
struct ReliefCost {
  double sigma;

  template <class T>
  bool operator()(const T* pixel, T* residual) const {
    residual[0] = pixel[3] / sigma;
    return true;
  }
};

/// The outline of a sphere: seen from `eye` above the sheet (0: infinitely far), place and radius
/// appear larger the higher the sphere's middle lies.
struct OutlineCost {
  Eigen::Vector3d prior;  // place and radius of the sphere of this outline on a table at height 0
  double sigma;
  double eye;

  template <class T>
  bool operator()(const T* sphere, const T* table, T* residuals) const {
    const T scale = eye > 0.0 ? (eye - prior.z()) / (eye - (*table + sphere[2])) : T(1.0);
    for (int i = 0; i < 3; ++i) residuals[i] = (sphere[i] * scale - prior[i]) / sigma;
    return true;
  }
};

/// What was known of `size` numbers before: a value and a standard deviation each.
template <int size>
struct PriorCost {
  Eigen::Matrix<double, size, 1> value;
  Eigen::Matrix<double, size, 1> sigma;

  template <class T>
  bool operator()(const T* x, T* residuals) const {
    for (int i = 0; i < size; ++i) residuals[i] = (x[i] - value[i]) / sigma[i];
    return true;
  }
};

}  // namespace hada
