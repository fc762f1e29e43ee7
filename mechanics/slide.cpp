#include "mechanics/slide.h"

#include <Eigen/Geometry>

#include "core/parallel.h"

namespace hada {

using Eigen::Vector3d;

KnitOnBody on_body(const Body& body, std::vector<MeshPlace> at, Places forces,
                   const std::vector<bool>& pinned, double friction) {
  const auto n = at.size();
  KnitOnBody s{std::move(at), std::move(forces)};
  s.frames.axes.resize(n), s.frames.turning.resize(n), s.normals.resize(n);
  s.press.resize(n);
  s.stuck.assign(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d normal = body.normal(s.at[i]);
    const Vector3d first = normal.unitOrthogonal();
    s.normals[i] = normal;
    s.frames.axes[i] << first, normal.cross(first), normal;
    s.press[i] = -normal.dot(s.load[i]);
    // The tangents t turn by -n (t . dn): the force onto the body comes to pull along it.
    s.frames.turning[i] = s.press[i] * body.curvature(s.at[i]);
    s.load[i] += s.press[i] * normal;
    const double along = s.load[i].norm(), held = friction * std::max(s.press[i], 0.0);
    if ((!pinned.empty() && pinned[i]) || along <= held) {
      s.stuck[i] = true;
      s.load[i].setZero();
    } else {
      s.load[i] *= 1.0 - held / along;
    }
    s.norm += s.load[i].squaredNorm();
    s.largest = std::max(s.largest, s.load[i].norm());
  }
  s.norm = std::sqrt(s.norm);
  return s;
}

Places smooth_places(const Body& body, const std::vector<MeshPlace>& at) {
  Places places;
  for (const MeshPlace& place : at) places.push_back(body.smooth_place(place));
  return places;
}

Places shortened(Places way, double longest_mm, bool each) {
  const double most = longest(way);
  for (Vector3d& w : way) {
    w *= std::min(1.0, longest_mm / std::max(each ? w.norm() : most, 1e-300));
  }
  return way;
}

std::vector<MeshPlace> slid(const Body& body, const std::vector<MeshPlace>& at, const Places& way) {
  auto next = at;
  for_each_index(int(at.size()), [&](int i) {
    const auto p = std::size_t(i);
    if (way[p].isZero(0.0)) return;
    next[p] = body.tree().closest(at[p].place - way[p], at[p].triangle);
  });
  return next;
}

}  // namespace hada
