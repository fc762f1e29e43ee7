#include "mechanics/wear.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/error.h"
#include "core/parallel.h"
#include "mechanics/drawn_over.h"
#include "mechanics/knit_newton.h"
#include "mechanics/slide.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr int worth_halving = 128;  // stitches each way

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

}  // namespace

void expect_wearable(const WearOptions& o) {
  if (o.courses < 3 || o.wales < 3 || o.axis < 0 || o.axis > 2 || !(o.girth > 0.0) ||
      !(o.length > 0.0) || !(o.ratio > 0.0) || o.repeat.empty() || !(o.friction >= 0.0)) {
    throw Error(
        "a worn knit needs 3 courses and 3 wales at least, and girth, length and stiffness "
        "greater than 0");
  }
}

WornKnit worn(const Body& body, const WearOptions& options) {
  expect_wearable(options);
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

  describe(result,
           laid_to_rest(result, body, net, KnitNewton(net, 2), std::move(at),
                        {.longest_mm = (options.friction > 0.0 ? rough_slide : free_slide) * girth,
                         .friction = options.friction,
                         .most_steps = options.most_steps,
                         .tolerance = options.tolerance}));
  return result;
}

}  // namespace hada
