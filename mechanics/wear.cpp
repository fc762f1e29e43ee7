#include "mechanics/wear.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/error.h"
#include "core/parallel.h"
#include "mechanics/drawn_over.h"
#include "mechanics/knit_newton.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double longest_slide = 0.3;  // of a step, over the girth of the tube at rest
constexpr int worth_halving = 128;     // stitches each way
constexpr double exactness = 5e-2;     // of a step
constexpr double uphill = 1.5;
constexpr double first_drag = 0.1;  // over the stiffness of nylon, once a step has failed
constexpr double least_drag = 1e-3;
// With friction the way counts, and must not lead beyond where points come to a stand: steps are
// short and dragged, and the search ends where no force exceeds the friction by more than a share
// of the largest tension.
constexpr double rough_slide = 0.02, rough_drag = 0.3;
constexpr double still = 2e-3;

// What pulls each point along the surface and is not held by friction; and the frames there.
struct Sliding {
  Places load;
  KnitFrames frames;
  std::vector<double> press;
  std::vector<bool> stuck;
  double norm = 0.0, largest = 0.0;
};

Sliding sliding(const Body& body, const KnitNet& net, const KnitSprings& springs,
                const std::vector<MeshPlace>& at, double friction) {
  const auto n = std::size_t(net.points());
  Sliding s;
  s.load = forces(net, springs);
  s.frames.axes.resize(n), s.frames.turning.resize(n);
  s.press.resize(n);
  s.stuck.assign(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d normal = body.normal(at[i]);
    const Vector3d first = normal.unitOrthogonal();
    s.frames.axes[i] << first, normal.cross(first), normal;
    s.press[i] = -normal.dot(s.load[i]);
    // The tangents t turn by -n (t . dn): the force onto the body comes to pull along it.
    s.frames.turning[i] = s.press[i] * body.curvature(at[i]);
    s.load[i] += s.press[i] * normal;
    const double along = s.load[i].norm(), held = friction * std::max(s.press[i], 0.0);
    if (net.is_pinned(int(i)) || along <= held) {
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

std::vector<MeshPlace> slid(const Body& body, const std::vector<MeshPlace>& at, const Places& way,
                            double share) {
  auto next = at;
  for_each_index(int(at.size()), [&](int i) {
    const auto p = std::size_t(i);
    if (way[p].isZero(0.0)) return;
    next[p] = body.tree().closest(at[p].place - share * way[p], at[p].triangle);
  });
  return next;
}

double largest_tension(const KnitSprings& springs) {
  double most = 1e-300;
  for (const double t : springs.along_tension) most = std::max(most, std::abs(t));
  for (const double t : springs.up_tension) most = std::max(most, std::abs(t));
  return most;
}

void describe(WornKnit& worn, const KnitSprings& springs) {
  const KnitNet& net = worn.net;
  for (int i = 0; i < net.points(); ++i) {
    const int wale = i % net.wales, left = i - wale + (wale + net.wales - 1) % net.wales;
    const auto p = std::size_t(i);
    worn.wale_mm.push_back(0.5 *
                           (springs.along_length[p] + springs.along_length[std::size_t(left)]));
    const bool has_up = i + net.wales < net.points(), has_down = i >= net.wales;
    const double up = springs.up_length[p],
                 down = has_down ? springs.up_length[p - std::size_t(net.wales)] : up;
    worn.course_mm.push_back(has_up ? 0.5 * (up + down) : down);
    const Vector3d across = has_up ? springs.up[p] : springs.up[p - std::size_t(net.wales)];
    worn.area_mm2.push_back(worn.wale_mm[p] * worn.course_mm[p] *
                            springs.along[p].cross(across).norm());
    worn.slack += springs.along_tension[p] < 0.0;
    worn.slack += springs.up_tension[p] < 0.0;
    worn.lifting += !net.is_pinned(i) && worn.press[p] < 0.0;
  }
}

// Where the points begin. Without friction the way does not matter: a tube of half as many stitches
// settles much sooner, and those between its own are nearly at rest.
std::vector<MeshPlace> beginning(const Body& body, const WearOptions& o, const TubeSpan& span,
                                 std::vector<MeshPlace> even) {
  if (o.friction > 0.0 || std::min(o.courses, o.wales) < worth_halving) return even;
  WearOptions half = o;
  half.courses = o.courses / 2, half.wales = o.wales / 2;
  half.from_mm = span.from, half.to_mm = span.to;
  const WornKnit coarse = worn(body, half);
  if (!coarse.settled) return even;
  for_each_index(o.courses - 2, [&](int inner) {
    const double y = (inner + 1.0) * (half.courses - 1.0) / (o.courses - 1.0);
    const int row = std::min(int(y), half.courses - 2);
    for (int wale = 0; wale < o.wales; ++wale) {
      const double x = double(wale) * half.wales / o.wales;
      const int col = int(x), next = (col + 1) % half.wales;
      const auto at = [&](int r, int c) { return coarse.places[std::size_t(r * half.wales + c)]; };
      const double u = x - col, v = y - row;
      const Vector3d place = (1.0 - v) * ((1.0 - u) * at(row, col) + u * at(row, next)) +
                             v * ((1.0 - u) * at(row + 1, col) + u * at(row + 1, next));
      even[std::size_t((inner + 1) * o.wales + wale)] =
          body.tree().closest(place, coarse.triangles[std::size_t(row * half.wales + col)]);
    }
  });
  return even;
}

void check(const WearOptions& o) {
  if (o.courses < 3 || o.wales < 3 || o.axis < 0 || o.axis > 2 || !(o.girth > 0.0) ||
      !(o.length > 0.0) || !(o.ratio > 0.0) || o.repeat.empty() || !(o.friction >= 0.0)) {
    throw Error(
        "a worn knit needs 3 courses and 3 wales at least, and girth, length and stiffness "
        "greater than 0");
  }
}

}  // namespace

WornKnit worn(const Body& body, const WearOptions& options) {
  check(options);
  const TubeSpan span = tube_span(body, options);
  auto at = drawn_over(body, options, span);
  const double girth = options.girth * smallest_girth(at, options);
  WornKnit result;
  KnitNet& net = result.net;
  net.courses = options.courses, net.wales = options.wales, net.round = true;
  net.wale_length = girth / options.wales;
  net.course_length = options.length * (span.to - span.from) / (options.courses - 1);
  net.stiffness = stiffness_of_courses(options.courses, options.ratio, options.repeat);
  net.continuity = options.continuity;
  at = beginning(body, options, span, std::move(at));
  net.pinned.assign(at.size(), false);
  std::fill_n(net.pinned.begin(), net.wales, true);
  std::fill_n(net.pinned.rbegin(), net.wales, true);

  KnitNewton newton(net, 2);
  KnitSprings springs = springs_of(net, smooth_places(body, at));
  Sliding now = sliding(body, net, springs, at, options.friction);
  const bool rough = options.friction > 0.0;
  double drag = rough ? rough_drag : 0.0;
  while (result.steps < options.most_steps && !result.settled && now.norm > 0.0) {
    ++result.steps;
    KnitNet held = net;
    held.pinned = now.stuck;
    const Places way = newton.step(held, springs, now.frames, now.load, exactness, drag);
    const double length = longest(way);
    if (!std::isfinite(length)) {  // nothing holds some point: only drag does
      drag = drag == 0.0 ? first_drag : 4.0 * drag;
      continue;
    }
    const double share =
        std::min(1.0, (rough ? rough_slide : longest_slide) * girth / std::max(length, 1e-300));
    auto next_at = slid(body, at, way, share);
    KnitSprings next_springs = springs_of(net, smooth_places(body, next_at));
    Sliding next = sliding(body, net, next_springs, next_at, options.friction);
    result.last_step = length / net.wale_length;
    result.settled = (drag == 0.0 && result.last_step < options.tolerance) ||
                     (rough && next.largest < still * largest_tension(springs));
    if (!result.settled && !(next.norm <= uphill * now.norm)) {
      drag = drag == 0.0 ? first_drag : 4.0 * drag;
      continue;
    }
    drag *= std::min(next.norm / now.norm, 0.5);
    if (drag < least_drag) drag = 0.0;
    if (rough) drag = std::max(drag, rough_drag);
    at = std::move(next_at), springs = std::move(next_springs), now = std::move(next);
  }
  result.settled = result.settled || now.norm == 0.0;
  result.sliding = now.largest / largest_tension(springs);
  for (const MeshPlace& place : at) {
    result.places.push_back(place.place);
    result.triangles.push_back(place.triangle);
    result.normals.push_back(body.normal(place));
  }
  result.press = std::move(now.press);
  describe(result, springs);
  return result;
}

}  // namespace hada
