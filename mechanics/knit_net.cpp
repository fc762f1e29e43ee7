#include "mechanics/knit_net.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/parallel.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// The neighbour of a point along its course, `steps` wales on; -1 beyond a border.
int along_course(const KnitNet& net, int point, int steps) {
  const int wale = point % net.wales, first = point - wale;
  const int other = wale + steps;
  if (other >= 0 && other < net.wales) return first + other;
  return net.round ? first + (other + net.wales) % net.wales : -1;
}

// Starting threads costs as much as the springs of some thousand points.
void for_courses(const KnitNet& net, const std::function<void(int begin, int end)>& work) {
  if (net.points() < 4096) return work(0, net.courses);
  for_slices(net.courses, work);
}

// Sums what springs with `pull` (a vector for each spring along and up) do to each point.
//   along_pull(spring, next)  of the spring along a course, next the one that its yarn runs on to
template <class Along, class Up>
Places gathered(const KnitNet& net, const Along& along_pull, const Up& up_pull) {
  Places sum(std::size_t(net.points()), Vector3d::Zero());
  for_courses(net, [&](int begin, int end) {
    for (int i = begin * net.wales; i < end * net.wales; ++i) {
      Vector3d& f = sum[std::size_t(i)];
      const int right = along_course(net, i, 1), left = along_course(net, i, -1);
      const auto has_spring = [&](int p) { return p >= 0 && along_course(net, p, 1) >= 0; };
      if (right >= 0) f += along_pull(i, has_spring(right) ? right : -1);
      if (left >= 0) f -= along_pull(left, along_course(net, i, -2));
      if (i + net.wales < net.points()) f += up_pull(i);
      if (i >= net.wales) f -= up_pull(i - net.wales);
    }
  });
  return sum;
}

}  // namespace

std::vector<double> stiffness_of_courses(int courses, double ratio,
                                         const std::vector<int>& repeat) {
  std::vector<double> stiffness(std::size_t(courses), 1.0);
  for (std::size_t j = 0; j < stiffness.size(); ++j) {
    if (repeat[j % repeat.size()] != 0) stiffness[j] = ratio;
  }
  return stiffness;
}

double longest(const Places& vectors) {
  double most = 0.0;
  for (const Vector3d& v : vectors) {
    if (!v.allFinite()) return HUGE_VAL;
    most = std::max(most, v.norm());
  }
  return most;
}

KnitSprings springs_of(const KnitNet& net, const Places& places) {
  const auto n = std::size_t(net.points());
  KnitSprings s{Places(n, Vector3d::Zero()), Places(n, Vector3d::Zero()), {}, {}, {}, {}};
  s.along_length.assign(n, 1.0), s.up_length.assign(n, 1.0);
  s.along_tension.assign(n, 0.0), s.up_tension.assign(n, 0.0);
  for_courses(net, [&](int begin, int end) {
    for (int i = begin * net.wales; i < end * net.wales; ++i) {
      const auto p = std::size_t(i);
      const double k = net.stiffness[std::size_t(i / net.wales)];
      const auto set = [&](int other, double rest, Vector3d& u, double& length, double& tension) {
        const Vector3d way = places[std::size_t(other)] - places[p];
        length = std::max(way.norm(), 1e-300);
        u = way / length;
        tension = k * (length - rest);
      };
      const int right = along_course(net, i, 1);
      if (right >= 0) {
        set(right, net.wale_length, s.along[p], s.along_length[p], s.along_tension[p]);
      }
      if (i + net.wales < net.points()) {
        set(i + net.wales, net.course_length, s.up[p], s.up_length[p], s.up_tension[p]);
      }
    }
  });
  return s;
}

double largest_tension(const KnitSprings& springs) {
  double most = 1e-300;
  for (const double t : springs.along_tension) most = std::max(most, std::abs(t));
  for (const double t : springs.up_tension) most = std::max(most, std::abs(t));
  return most;
}

Places forces(const KnitNet& net, const KnitSprings& s) {
  const auto along = [&](int spring, int next) -> Vector3d {
    const double handed = next >= 0 ? net.continuity * s.along_tension[std::size_t(next)] : 0.0;
    return (s.along_tension[std::size_t(spring)] + handed) * s.along[std::size_t(spring)];
  };
  return gathered(net, along, [&](int spring) -> Vector3d {
    return s.up_tension[std::size_t(spring)] * s.up[std::size_t(spring)];
  });
}

Places continuity_forces(const KnitNet& net, const KnitSprings& s) {
  const auto along = [&](int spring, int next) -> Vector3d {
    return (next >= 0 ? s.along_tension[std::size_t(next)] : 0.0) * s.along[std::size_t(spring)];
  };
  return gathered(net, along, [](int) -> Vector3d { return Vector3d::Zero(); });
}

Places force_changes(const KnitNet& net, const KnitSprings& s, const Places& way) {
  const auto stiffness = [&](int spring) { return net.stiffness[std::size_t(spring / net.wales)]; };
  const auto along_way = [&](int spring) -> Vector3d {
    return way[std::size_t(along_course(net, spring, 1))] - way[std::size_t(spring)];
  };
  const auto turned = [](const Vector3d& u, const Vector3d& d, double length) -> Vector3d {
    return (d - u * u.dot(d)) / length;
  };
  const auto along = [&](int spring, int next) -> Vector3d {
    const auto p = std::size_t(spring);
    const double k = stiffness(spring);
    const Vector3d d = along_way(spring);
    double tension = s.along_tension[p], change = k * s.along[p].dot(d);
    if (next >= 0) {
      tension += net.continuity * s.along_tension[std::size_t(next)];
      change += net.continuity * k * s.along[std::size_t(next)].dot(along_way(next));
    }
    return change * s.along[p] + tension * turned(s.along[p], d, s.along_length[p]);
  };
  return gathered(net, along, [&](int spring) -> Vector3d {
    const auto p = std::size_t(spring);
    const Vector3d d = way[p + std::size_t(net.wales)] - way[p];
    return stiffness(spring) * s.up[p].dot(d) * s.up[p] +
           s.up_tension[p] * turned(s.up[p], d, s.up_length[p]);
  });
}

}  // namespace hada
