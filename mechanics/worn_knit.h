#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mechanics/shell_net.h"
#include "mechanics/slide.h"

namespace hada {

/// A knit on a body. Lists have an entry for each point of the net.
struct WornKnit {
  KnitNet net;                         // of a tube
  std::optional<ShellNet> shell = {};  // of a knit that is no tube; `net` is then empty
  Places places;
  Places normals;                          // of the body there, outward
  std::vector<int> triangles;              // of the body's mesh
  std::vector<double> press;               // force on the body, in lengths of mm times k of nylon
  std::vector<double> area_mm2;            // of the knit that belongs to the point
  std::vector<double> wale_mm, course_mm;  // distances of stitches there
  int steps = 0;
  bool settled = false;
  double last_step = 0.0;  // over the distance of wales
  double sliding = 0.0;    // largest force left along the body, over the largest tension
  int slack = 0;           // springs that push: they buckle, and a rest may not be found
  int lifting = 0;         // points that the body would have to hold: a knit would bridge there
};

/// The course and the wale of a point; of a shell, the wale as it was begun with.
int course_of(const WornKnit& knit, int point);
int wale_of(const WornKnit& knit, int point);

/// A spring of a knit: those along the courses first, then those up the wales.
struct WornSpring {
  int from = 0, to = 0;
  double stiffness = 1.0;  // k of its yarn
};
std::vector<WornSpring> springs_of(const KnitNet& net);
std::vector<WornSpring> springs_of(const WornKnit& knit);

/// The faces of a knit; their springs are counted as those of `springs_of`.
std::vector<ShellCell> cells_of(const WornKnit& knit);

/// Fills in where points came to rest and how hard they press.
void take_rest(WornKnit& knit, const AtRestOnBody& rest, const std::vector<bool>& pinned,
               double largest_tension);

/// Lets a net slide to rest, and fills in the same; returns its springs as they are then.
template <class Net, class Newton>
auto laid_to_rest(WornKnit& knit, const Body& body, const Net& net, Newton&& newton,
                  std::vector<MeshPlace> at, const SlideOptions& options) {
  const auto rest = slid_to_rest(body, net, newton, std::move(at), options);
  auto springs = springs_of(net, smooth_places(body, rest.knit.at));
  take_rest(knit, rest, net.pinned, largest_tension(springs));
  return springs;
}

}  // namespace hada
