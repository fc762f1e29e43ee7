#include "mechanics/knit_rest.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "mechanics/knit_newton.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double exactness = 1e-3;  // of a step: so much of the forces is left after it
constexpr double uphill = 1.5;      // so far forces may grow in a step that is taken
constexpr double first_drag = 0.1;  // over the stiffness of nylon, once a step has failed
constexpr double least_drag = 1e-6;

Places pulls(const KnitNet& net, const KnitSprings& springs) {
  Places f = forces(net, springs);
  for (int i = 0; i < net.points(); ++i) {
    if (net.is_pinned(i)) f[std::size_t(i)].setZero();
  }
  return f;
}

double norm_of(const Places& vectors) {
  double sum = 0.0;
  for (const Vector3d& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum);
}

// J s = F is solved; the step of Newton is -s.
Places moved(const Places& places, const Places& way) {
  Places next = places;
  for (std::size_t i = 0; i < next.size(); ++i) next[i] -= way[i];
  return next;
}

}  // namespace

void expect_whole(const KnitNet& net, const Places& places) {
  const auto n = std::size_t(net.points());
  if (net.wales < 3 || net.courses < 2 || places.size() != n ||
      net.stiffness.size() != std::size_t(net.courses) ||
      (!net.pinned.empty() && net.pinned.size() != n)) {
    throw Error("a knit needs 3 wales and 2 courses at least, a place for each of its points and " +
                std::string("a stiffness for each of its courses"));
  }
}

KnitAtRest knit_at_rest(const KnitNet& net, Places start, const KnitRestOptions& options) {
  expect_whole(net, start);
  const bool flat =
      std::all_of(start.begin(), start.end(), [](const Vector3d& p) { return p.z() == 0.0; });
  const KnitFrames frames{flat ? 2 : 3,
                          {start.size(), Eigen::Matrix3d(Eigen::Matrix3d::Identity())}};
  KnitNewton newton(net, frames.free);
  KnitAtRest rest{std::move(start)};
  KnitSprings springs = springs_of(net, rest.places);
  Places load = pulls(net, springs);
  double drag = 0.0;
  while (rest.steps < options.most_steps && !rest.settled) {
    ++rest.steps;
    const double before = norm_of(load);
    if (before == 0.0) {
      rest.settled = true;
      break;
    }
    const Places way = newton.step(net, springs, frames, load, exactness, drag);
    Places next = moved(rest.places, way);
    KnitSprings next_springs = springs_of(net, next);
    Places next_load = pulls(net, next_springs);
    const double after = norm_of(next_load);
    rest.last_step = longest(way) / net.wale_length;
    // A step that is too short to matter ends the search, even if rounding made it lead uphill.
    rest.settled = drag == 0.0 && rest.last_step < options.tolerance;
    if (!rest.settled && !(after <= uphill * before)) {
      drag = drag == 0.0 ? first_drag : 4.0 * drag;
      continue;
    }
    rest.places = std::move(next);
    springs = std::move(next_springs);
    load = std::move(next_load);
    drag *= std::min(after / before, 0.7);
    if (drag < least_drag) drag = 0.0;
  }
  rest.force_left = longest(load) / largest_tension(springs);
  return rest;
}

}  // namespace hada
