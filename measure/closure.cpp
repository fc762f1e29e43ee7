#include "measure/closure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Geometry>

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double lack_of(const std::vector<ClosureWay>& ways) {
  std::vector<std::pair<double, Vector3d>> around;  // by direction seen from above
  for (const ClosureWay& w : ways) {
    const double rise = 0.5 * (w.one + w.two).dot(w.way);
    around.emplace_back(std::atan2(w.way.y(), w.way.x()), Vector3d(w.way.x(), w.way.y(), rise));
  }
  std::sort(around.begin(), around.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  double sum = 0.0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Vector3d &a = around[i].second, &b = around[(i + 1) % around.size()].second;
    sum += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return 2.0 * std::numbers::pi - sum;
}

}  // namespace

Closure closure_of(const std::vector<ClosureWay>& ways) {
  Closure closure;
  closure.lack = lack_of(ways);
  double variance = 0.0;
  // Each cause by itself, one standard deviation to both sides.
  const auto add = [&](const auto& change) {
    std::vector<ClosureWay> more = ways, less = ways;
    change(more, 1.0);
    change(less, -1.0);
    variance += std::pow(0.5 * (lack_of(more) - lack_of(less)), 2);
  };
  std::set<int> done;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    add([&](std::vector<ClosureWay>& all, double by) {
      all[i].way = Eigen::Rotation2Dd(by * ways[i].way_sigma) * all[i].way;
    });
    for (const auto& [facet, sigma] : {std::pair{ways[i].one_facet, ways[i].one_sigma},
                                       {ways[i].two_facet, ways[i].two_sigma}}) {
      if (!done.insert(facet).second) continue;
      for (int axis = 0; axis < 2; ++axis) {
        add([&, facet = facet, sigma = sigma](std::vector<ClosureWay>& all, double by) {
          for (ClosureWay& w : all) {
            if (w.one_facet == facet) w.one[axis] += by * sigma;
            if (w.two_facet == facet) w.two[axis] += by * sigma;
          }
        });
      }
    }
  }
  closure.sigma = std::sqrt(variance);
  return closure;
}

}  // namespace hada
