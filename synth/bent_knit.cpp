#include "synth/bent_knit.h"

#include <array>
#include <cmath>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr int most_stitches = 30000;  // that a map of loops can number

// Weights of the crossings before, at, after and after next.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (t * (2.0 - t) - 1.0), 0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
          0.5 * t * (t * (4.0 - 3.0 * t) + 1.0), 0.5 * t * t * (t - 1.0)};
}

}  // namespace

Vector2d BentKnit::at(int wale, int course) const {
  if (wale < 0) return 2.0 * at(0, course) - at(-wale, course);
  if (wale >= wales) return 2.0 * at(wales - 1, course) - at(2 * (wales - 1) - wale, course);
  if (course < 0) return 2.0 * at(wale, 0) - at(wale, -course);
  if (course >= courses) {
    return 2.0 * at(wale, courses - 1) - at(wale, 2 * (courses - 1) - course);
  }
  return places[std::size_t(course * wales + wale)].head<2>();
}

Vector2d BentKnit::straight(double wale, double course) const {
  const int i = int(std::floor(wale)), j = int(std::floor(course));
  const double u = wale - i, v = course - j;
  return (1.0 - v) * ((1.0 - u) * at(i, j) + u * at(i + 1, j)) +
         v * ((1.0 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

Vector2d BentKnit::smooth(double wale, double course) const {
  const int i = int(std::floor(wale)), j = int(std::floor(course));
  const auto along = cubic_weights(wale - i), up = cubic_weights(course - j);
  Vector2d sum = Vector2d::Zero();
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) {
      sum += up[std::size_t(b)] * along[std::size_t(a)] * at(i + a - 1, j + b - 1);
    }
  }
  return sum;
}

std::vector<YarnPoint> bent_loops(const Knit<>& knit, const BentKnit& bent, const Extent& extent,
                                  BetweenCrossings between, const std::vector<Vector2d>& shift) {
  if (bent.courses < 3 || bent.wales < 3 || bent.courses > most_stitches / bent.wales ||
      bent.places.size() != std::size_t(bent.courses * bent.wales)) {
    throw Error("loops of a piece of knit need a place for each of its crossings, 30000 at most");
  }
  std::vector<YarnPoint> points;
  const auto curve = loop_curve(knit);
  points.reserve(curve.size() * bent.places.size());
  for (int k = 0; k < bent.courses * bent.wales; ++k) {
    const int wale = k % bent.wales, course = k / bent.wales;
    for (const auto& [wales, courses, z] : curve) {
      Vector2d place = (bent.*between)(wale + wales, course + courses);
      if (!shift.empty()) place += shift[std::size_t(k)];
      const Vector2d pixel = extent.pixel(place);
      points.push_back({pixel[0], pixel[1], z, k});
    }
  }
  return points;
}

}  // namespace hada
