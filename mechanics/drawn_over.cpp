#include "mechanics/drawn_over.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {

using Eigen::Vector3d;

Outline outline_at(const Body& body, int axis, double height) {
  Vector3d sum = Vector3d::Zero();
  double length = 0.0;
  for (const auto& t : body.mesh().triangles) {
    std::vector<Vector3d> cut;
    for (std::size_t s = 0; s < 3; ++s) {
      const Vector3d& a = body.mesh().vertices_mm[std::size_t(t[s])];
      const Vector3d& b = body.mesh().vertices_mm[std::size_t(t[(s + 1) % 3])];
      if ((a[axis] < height) == (b[axis] < height)) continue;
      cut.push_back(a + (b - a) * ((height - a[axis]) / (b[axis] - a[axis])));
    }
    if (cut.size() != 2) continue;
    const double part = (cut[1] - cut[0]).norm();
    sum += part * 0.5 * (cut[0] + cut[1]), length += part;
  }
  if (length == 0.0) {
    throw Error(fmt::format("the body has no outline at {:g} mm", height));
  }
  return {sum / length, length};
}

TubeSpan tube_span(const Body& body, const WearOptions& options) {
  Vector3d low = body.mesh().vertices_mm[0], high = low;
  for (const Vector3d& v : body.mesh().vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const double bottom = low[options.axis], top = high[options.axis];
  const double margin = 0.05 * (top - bottom);
  const TubeSpan span{options.from_mm.value_or(bottom + margin),
                      options.to_mm.value_or(top - margin), (high - low).norm()};
  if (!(span.from >= bottom && span.to <= top && span.from < span.to)) {
    throw Error(
        fmt::format("the knit must be drawn from a lower to a higher place of the body, which "
                    "reaches from {:g} to {:g} mm",
                    bottom, top));
  }
  return span;
}

std::vector<MeshPlace> drawn_over(const Body& body, const WearOptions& o, const TubeSpan& span) {
  std::vector<MeshPlace> places(std::size_t(o.courses * o.wales));
  for_each_index(o.courses, [&](int course) {
    const double height = span.from + (span.to - span.from) * course / (o.courses - 1.0);
    const Vector3d middle = outline_at(body, o.axis, height).middle;
    const Vector3d u = Vector3d::Unit((o.axis + 1) % 3), v = Vector3d::Unit((o.axis + 2) % 3);
    for (int wale = 0; wale < o.wales; ++wale) {
      const double turn = 2.0 * std::numbers::pi * wale / o.wales;
      const Vector3d out = std::cos(turn) * u + std::sin(turn) * v;
      const MeshPlace hit = body.tree().first_hit(middle + span.reach * out, -out);
      if (hit.triangle < 0 || hit.distance >= span.reach) {
        throw Error(
            fmt::format("the body has no surface on one side at {:g} mm: draw the knit over a "
                        "part that is closed around",
                        height));
      }
      places[std::size_t(course * o.wales + wale)] = hit;
    }
  });
  return places;
}

double smallest_girth(const std::vector<MeshPlace>& places, const WearOptions& o) {
  double smallest = HUGE_VAL;
  for (int course = 0; course < o.courses; ++course) {
    double girth = 0.0;
    for (int wale = 0; wale < o.wales; ++wale) {
      const auto at = [&](int w) { return places[std::size_t(course * o.wales + w % o.wales)]; };
      girth += (at(wale + 1).place - at(wale).place).norm();
    }
    smallest = std::min(smallest, girth);
  }
  return smallest;
}
}  // namespace hada
