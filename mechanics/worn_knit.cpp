#include "mechanics/worn_knit.h"

namespace hada {

int course_of(const WornKnit& knit, int point) {
  return knit.shell ? knit.shell->course[std::size_t(point)] : point / knit.net.wales;
}

int wale_of(const WornKnit& knit, int point) {
  return knit.shell ? knit.shell->wale[std::size_t(point)] : point % knit.net.wales;
}

std::vector<WornSpring> springs_of(const KnitNet& net) {
  std::vector<WornSpring> springs;
  const auto k = [&](int point) {
    const auto course = std::size_t(point / net.wales);
    return course < net.stiffness.size() ? net.stiffness[course] : 1.0;
  };
  for (int i = 0; i < net.points(); ++i) {
    const int wale = i % net.wales;
    if (wale + 1 < net.wales || net.round) {
      springs.push_back({i, i - wale + (wale + 1) % net.wales, k(i)});
    }
  }
  for (int i = 0; i + net.wales < net.points(); ++i) springs.push_back({i, i + net.wales, k(i)});
  return springs;
}

std::vector<WornSpring> springs_of(const WornKnit& knit) {
  if (!knit.shell) return springs_of(knit.net);
  std::vector<WornSpring> springs;
  for (int k = 0; k < int(knit.shell->springs.size()); ++k) {
    const ShellSpring& spring = knit.shell->springs[std::size_t(k)];
    springs.push_back({spring.from, spring.to, knit.shell->k(k)});
  }
  return springs;
}

std::vector<ShellCell> cells_of(const WornKnit& knit) {
  if (knit.shell) return cells_of(*knit.shell);
  const int w = knit.net.wales, n = knit.net.points();
  std::vector<ShellCell> cells;
  for (int a = 0; a + w < n; ++a) {
    const int b = a - a % w + (a % w + 1) % w;
    cells.push_back({{a, b, b + w, a + w}, {a, a + w, n + a, n + b}, a, n + a});
  }
  return cells;
}

void take_rest(WornKnit& knit, const AtRestOnBody& rest, const std::vector<bool>& pinned,
               double largest_tension) {
  knit.steps = rest.steps, knit.settled = rest.settled, knit.last_step = rest.last_step;
  knit.sliding = rest.knit.largest / largest_tension;
  for (const MeshPlace& place : rest.knit.at) {
    knit.places.push_back(place.place);
    knit.triangles.push_back(place.triangle);
  }
  knit.normals = rest.knit.normals;
  knit.press = rest.knit.press;
  for (std::size_t i = 0; i < knit.press.size(); ++i) {
    knit.lifting += !(!pinned.empty() && pinned[i]) && knit.press[i] < 0.0;
  }
}

}  // namespace hada
