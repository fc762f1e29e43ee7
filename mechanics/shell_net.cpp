#include "mechanics/shell_net.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double buckled = 0.01;  // stiffness of slack yarn, over that of taut yarn

Vector3d turned(const Vector3d& u, const Vector3d& d, double length) {
  return (d - u * u.dot(d)) / length;
}

/// Adds what each spring does to its two ends. `pull(spring, next)`: with the tension that comes
/// from the spring `next` of its yarn, or -1.
template <class Pull>
Places gathered(const ShellNet& net, const Pull& pull) {
  Places sum(std::size_t(net.points()), Vector3d::Zero());
  for (int s = 0; s < int(net.springs.size()); ++s) {
    const ShellSpring& spring = net.springs[std::size_t(s)];
    sum[std::size_t(spring.from)] += pull(s, spring.after);
    sum[std::size_t(spring.to)] -= pull(s, spring.before);
  }
  return sum;
}

std::pair<int, int> sorted(int a, int b) {
  return std::minmax({a, b});
}

/// The stitches of a net by how they hang together; -1 where there is none.
struct Neighbours {
  std::vector<int> next, along, above, up;  // next stitch and the spring to it; the same above
  std::map<std::pair<int, int>, int> springs;

  explicit Neighbours(const ShellNet& net) {
    const auto n = std::size_t(net.points());
    for (auto* all : {&next, &along, &above, &up}) all->assign(n, -1);
    for (int s = 0; s < int(net.springs.size()); ++s) {
      const auto [from, to, course, before, after] = net.springs[std::size_t(s)];
      springs[sorted(from, to)] = s;
      const auto f = std::size_t(from);
      if (s >= net.along) {
        above[f] = to, up[f] = s;
      } else if (net.course[f] == net.course[std::size_t(to)]) {
        next[f] = to, along[f] = s;
      }
    }
  }
  std::vector<int> sides(const std::vector<int>& corners) const {
    std::vector<int> all;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto side = springs.find(sorted(corners[k], corners[(k + 1) % corners.size()]));
      if (side != springs.end()) all.push_back(side->second);
    }
    return all;
  }
  bool joined(int a, int b) const { return springs.count(sorted(a, b)) > 0; }
};

/// The stitches from one up its wale, itself first.
std::vector<int> climbed(const Neighbours& at, int point, int most) {
  std::vector<int> way{point};
  while (int(way.size()) <= most && at.above[std::size_t(way.back())] >= 0) {
    way.push_back(at.above[std::size_t(way.back())]);
  }
  return way;
}

}  // namespace

ShellSprings springs_of(const ShellNet& net, const Places& places) {
  ShellSprings s;
  for (int k = 0; k < int(net.springs.size()); ++k) {
    const ShellSpring& spring = net.springs[std::size_t(k)];
    const Vector3d way = places[std::size_t(spring.to)] - places[std::size_t(spring.from)];
    s.length.push_back(std::max(way.norm(), 1e-300));
    s.directions.push_back(way / s.length.back());
    const double longer = s.length.back() - (k < net.along ? net.wale_length : net.course_length);
    s.stiffness.push_back(longer < 0.0 ? buckled * net.k(k) : net.k(k));
    s.tension.push_back(s.stiffness.back() * longer);
  }
  return s;
}

double largest_tension(const ShellSprings& springs) {
  double most = 1e-300;
  for (const double t : springs.tension) most = std::max(most, std::abs(t));
  return most;
}

Places forces(const ShellNet& net, const ShellSprings& s) {
  return gathered(net, [&](int spring, int next) -> Vector3d {
    const double handed = next >= 0 ? net.continuity * s.tension[std::size_t(next)] : 0.0;
    return (s.tension[std::size_t(spring)] + handed) * s.directions[std::size_t(spring)];
  });
}

Places force_changes(const ShellNet& net, const ShellSprings& s, const Places& way) {
  const auto moved = [&](int spring) -> Vector3d {
    const ShellSpring& at = net.springs[std::size_t(spring)];
    return way[std::size_t(at.to)] - way[std::size_t(at.from)];
  };
  const auto drawn_out = [&](int spring) {
    return s.stiffness[std::size_t(spring)] * s.directions[std::size_t(spring)].dot(moved(spring));
  };
  return gathered(net, [&](int spring, int next) -> Vector3d {
    const auto p = std::size_t(spring);
    double tension = s.tension[p], change = drawn_out(spring);
    if (next >= 0) {
      tension += net.continuity * s.tension[std::size_t(next)];
      change += net.continuity * drawn_out(next);
    }
    return change * s.directions[p] + tension * turned(s.directions[p], moved(spring), s.length[p]);
  });
}

std::vector<ShellCell> cells_of(const ShellNet& net) {
  const Neighbours at(net);
  std::vector<ShellCell> cells;
  for (int i = 0; i < net.points(); ++i) {
    const int r = at.next[std::size_t(i)];
    if (r < 0 || at.above[std::size_t(i)] < 0) continue;
    // Up both wales to where they meet or lie side by side: straight across as a rule, further up
    // one of them where the other goes past courses that do not reach it.
    std::vector<int> left = climbed(at, i, 1), right = climbed(at, r, 1);
    if (right.size() < 2) continue;
    std::size_t a = 1, b = 1;
    const auto beside = [&](std::size_t x, std::size_t y) {
      return left[x] == right[y] || at.next[std::size_t(left[x])] == right[y];
    };
    if (!beside(a, b)) {
      left = climbed(at, i, net.points()), right = climbed(at, r, net.points());
      const auto reach = std::max(left.size(), right.size());
      for (std::size_t high = 2; high < reach; ++high) {
        if (high < right.size() && beside(1, high)) {
          b = high;
          break;
        }
        if (high < left.size() && beside(high, 1)) {
          a = high;
          break;
        }
      }
    }
    left.resize(a + 1), right.resize(b + 1);
    // The side that goes straight up looks at all of the other one.
    const bool from_left = a <= b;
    std::vector<int> across = from_left ? right : left;
    const int foot = from_left ? i : r, head = from_left ? left.back() : right.back();
    if (across.back() != head) across.push_back(head);
    // A yarn that is wrapped around the foot cuts the face in two.
    std::vector<int> corners{foot};
    for (std::size_t k = 0; k < across.size(); ++k) {
      corners.push_back(across[k]);
      const bool last = k + 1 == across.size();
      if (!last && (k == 0 || !at.joined(foot, across[k]))) continue;
      if (!from_left) std::reverse(corners.begin() + 1, corners.end());
      cells.push_back(
          {corners, at.sides(corners), at.along[std::size_t(i)], at.up[std::size_t(foot)]});
      corners = {foot, across[k]};
    }
  }
  return cells;
}

}  // namespace hada
