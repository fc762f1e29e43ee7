#include "synth/cut.h"

#include <cmath>

#include "core/error.h"

namespace hada {
namespace {

double dot(const StemVector& a, const StemVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

StemVector unit(const StemVector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

StemVector cross(const StemVector& a, const StemVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

StemVector Cut::towards_eye() const {
  return cross(right, up);
}

Cut cut_along(const StemVector& origin, const StemVector& right, const StemVector& up) {
  const StemVector across = cross(right, up);
  if (!(dot(across, across) > 1e-12 * dot(right, right) * dot(up, up))) {
    throw Error(
        "wood: the two directions of a cut do not span a plane; give two that are not parallel");
  }
  Cut cut{origin, unit(right), {}};
  cut.up = cross(unit(across), cut.right);
  return cut;
}

}  // namespace hada
