#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mechanics/body.h"
#include "mechanics/knit_frames.h"

namespace hada {

// The longest step, over the girth at rest, as a rule: with friction the way counts.
constexpr double free_slide = 0.3, rough_slide = 0.02;

struct SlideOptions {
  double longest_mm = 1.0;  // that a point goes in a step
  bool each = false;        // longer ways are cut one by one, not all by the same share
  double friction = 0.0;
  int most_steps = 100;
  double tolerance = 1e-3;  // of a step, over the distance of wales, where it ends
};

/// Points of a knit on a body, and what pulls them there.
struct KnitOnBody {
  std::vector<MeshPlace> at;
  Places load;                       // along the surface, what friction does not hold
  KnitFrames frames = {};            // two tangents and the normal
  Places normals = {};               // outward
  std::vector<double> press = {};    // onto the surface
  std::vector<bool> stuck = {};      // pinned or held by friction
  double norm = 0.0, largest = 0.0;  // of the load
};

/// `forces` as the surface takes them up; `pinned` as a net has it.
KnitOnBody on_body(const Body& body, std::vector<MeshPlace> at, Places forces,
                   const std::vector<bool>& pinned, double friction);

/// Where the smooth surface is that the triangles stand for.
Places smooth_places(const Body& body, const std::vector<MeshPlace>& at);

/// Ways of which none is longer than `longest_mm`: all times a share, or each cut by itself.
Places shortened(Places way, double longest_mm, bool each);

/// Points that went back along `way`, and onto the body again.
std::vector<MeshPlace> slid(const Body& body, const std::vector<MeshPlace>& at, const Places& way);

/// Where and how points came to rest.
struct AtRestOnBody {
  KnitOnBody knit;
  int steps = 0;
  bool settled = false;
  double last_step = 0.0;  // over the distance of wales
};

/// Newton steps in the tangent planes and back onto the surface, dragged where they lead uphill,
/// until nothing pulls along it. With friction the way counts, and must not lead beyond where
/// points come to a stand: steps are short and dragged, and the search ends where no force exceeds
/// the friction by more than a share of the largest tension.
template <class Net, class Newton>
AtRestOnBody slid_to_rest(const Body& body, const Net& net, Newton&& newton,
                          std::vector<MeshPlace> at, const SlideOptions& options) {
  constexpr double exactness = 5e-2;  // of a step
  constexpr double uphill = 1.5;
  constexpr double first_drag = 0.1;  // over the stiffness of nylon, once a step has failed
  constexpr double least_drag = 1e-3, rough_drag = 0.3;
  constexpr double still = 2e-3;
  const auto laid = [&](std::vector<MeshPlace> places, const auto& springs) {
    return on_body(body, std::move(places), forces(net, springs), net.pinned, options.friction);
  };
  auto springs = springs_of(net, smooth_places(body, at));
  AtRestOnBody rest{laid(std::move(at), springs)};
  KnitOnBody& now = rest.knit;
  const bool rough = options.friction > 0.0;
  double drag = rough ? rough_drag : 0.0;
  const auto drag_more = [&] { drag = drag == 0.0 ? first_drag : 4.0 * drag; };
  while (rest.steps < options.most_steps && !rest.settled && now.norm > 0.0) {
    ++rest.steps;
    Net held = net;
    held.pinned = now.stuck;
    const Places way = newton.step(held, springs, now.frames, now.load, exactness, drag);
    const double length = longest(way);
    if (!std::isfinite(length)) {  // nothing holds some point: only drag does
      drag_more();
      continue;
    }
    auto next_at = slid(body, now.at, shortened(way, options.longest_mm, options.each));
    auto next_springs = springs_of(net, smooth_places(body, next_at));
    KnitOnBody next = laid(std::move(next_at), next_springs);
    rest.last_step = length / net.wale_length;
    rest.settled = (drag == 0.0 && rest.last_step < options.tolerance) ||
                   (rough && next.largest < still * largest_tension(next_springs));
    if (!rest.settled && !(next.norm <= uphill * now.norm)) {
      drag_more();
      continue;
    }
    drag *= std::min(next.norm / now.norm, 0.5);
    if (drag < least_drag) drag = 0.0;
    if (rough) drag = std::max(drag, rough_drag);
    now = std::move(next), springs = std::move(next_springs);
  }
  rest.settled = rest.settled || now.norm == 0.0;
  return rest;
}

}  // namespace hada
