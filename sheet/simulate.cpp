#include "sheet/simulate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double flat_length(const Sheet& sheet, int a, int b) {
  return (sheet.flat[std::size_t(a)] - sheet.flat[std::size_t(b)]).norm();
}

// The corner of the face left of a half-edge that is furthest from its line.
int wing(const Sheet& sheet, int half) {
  const Vector2d from = sheet.flat[std::size_t(sheet.origin(half))];
  const Vector2d way = sheet.flat[std::size_t(sheet.target(half))] - from;
  int best = -1;
  double furthest = -1.0;
  for (const int v : sheet.corners_of(sheet.half(half).face)) {
    const Vector2d to = sheet.flat[std::size_t(v)] - from;
    const double height = way.x() * to.y() - way.y() * to.x();
    if (height <= furthest) continue;
    furthest = height;
    best = v;
  }
  return best;
}

Hinge hinge_of(const Sheet& sheet, int edge) {
  Hinge hinge;
  hinge.from = sheet.origin(2 * edge);
  hinge.to = sheet.target(2 * edge);
  hinge.left = wing(sheet, 2 * edge);
  hinge.right = wing(sheet, 2 * edge + 1);
  return hinge;
}

void add_bars(BarNetwork& network, const Sheet& sheet, const std::set<std::pair<int, int>>& pairs,
              double axial) {
  for (const auto& [a, b] : pairs) {
    const double length = flat_length(sheet, a, b);
    network.bars.push_back({a, b, length, axial / length});
  }
}

// Faces with more than three corners are cut along diagonals, always off the sharpest corner that
// leaves the others to one side; the diagonals bend.

double twice_area(const Sheet& sheet, int a, int b, int c) {
  const Vector2d u = sheet.flat[std::size_t(b)] - sheet.flat[std::size_t(a)];
  const Vector2d v = sheet.flat[std::size_t(c)] - sheet.flat[std::size_t(a)];
  return u.x() * v.y() - u.y() * v.x();
}

std::vector<std::array<int, 3>> ears(const Sheet& sheet, std::vector<int> face) {
  std::vector<std::array<int, 3>> triangles;
  while (face.size() > 3) {
    std::size_t best = 0;
    double shortest = 1e300;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[(i + face.size() - 1) % face.size()], b = face[i],
                c = face[(i + 1) % face.size()];
      if (twice_area(sheet, a, b, c) <= 0.0) continue;
      const bool clear = std::none_of(face.begin(), face.end(), [&](int p) {
        return p != a && p != b && p != c && twice_area(sheet, a, b, p) >= 0.0 &&
               twice_area(sheet, b, c, p) >= 0.0 && twice_area(sheet, c, a, p) >= 0.0;
      });
      const double length = flat_length(sheet, a, c);
      if (!clear || length >= shortest) continue;
      shortest = length;
      best = i;
    }
    triangles.push_back(
        {face[(best + face.size() - 1) % face.size()], face[best], face[(best + 1) % face.size()]});
    face.erase(face.begin() + std::ptrdiff_t(best));
  }
  triangles.push_back({face[0], face[1], face[2]});
  return triangles;
}

void add_corners(BarNetwork& network, const Sheet& sheet, const std::array<int, 3>& triangle,
                 double stiffness) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int at = triangle[i], from = triangle[(i + 1) % 3], to = triangle[(i + 2) % 3];
    const Vector2d u = sheet.flat[std::size_t(from)] - sheet.flat[std::size_t(at)];
    const Vector2d v = sheet.flat[std::size_t(to)] - sheet.flat[std::size_t(at)];
    const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    network.corners.push_back({at, from, to, angle, stiffness});
  }
}

// Half the diagonal of the smallest upright rectangle around the sheet.
double radius_of(const Sheet& sheet) {
  Vector2d low = sheet.flat[0], high = low;
  for (const Vector2d& p : sheet.flat) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 0.5 * (high - low).norm();
}

BarNetwork elastic_network(const Sheet& sheet, const SimulateOptions& options) {
  BarNetwork network;
  const double corner = options.corner_stiffness * radius_of(sheet);
  std::set<std::pair<int, int>> pairs;
  for (int e = 0; e < sheet.edges(); ++e) {
    pairs.insert(std::minmax(sheet.origin(2 * e), sheet.target(2 * e)));
    if (sheet.is_border(e)) continue;
    Hinge hinge = hinge_of(sheet, e);
    const bool folds = is_folded(sheet.creases[std::size_t(e)]);
    hinge.stiffness = (folds ? options.fold_stiffness : options.facet_stiffness) *
                      flat_length(sheet, hinge.from, hinge.to);
    network.hinges.push_back(hinge);
  }
  for (int f = 0; f < sheet.faces(); ++f) {
    const auto triangles = ears(sheet, sheet.corners_of(f));
    for (const auto& triangle : triangles) add_corners(network, sheet, triangle, corner);
    for (std::size_t i = 0; i + 1 < triangles.size(); ++i) {
      // The cut of an ear a-b-c is c-a; the triangle beyond it is found among the later ones.
      const auto [a, b, c] = triangles[i];
      pairs.insert(std::minmax(a, c));
      for (std::size_t j = i + 1; j < triangles.size(); ++j) {
        const auto& other = triangles[j];
        const auto has = [&](int v) { return std::count(other.begin(), other.end(), v) > 0; };
        if (!has(a) || !has(c)) continue;
        const int beyond = *std::find_if(other.begin(), other.end(),
                                         [a = a, c = c](int v) { return v != a && v != c; });
        network.hinges.push_back(
            {c, a, b, beyond, 0.0, options.facet_stiffness * flat_length(sheet, a, c)});
        break;
      }
    }
  }
  add_bars(network, sheet, pairs, options.axial_stiffness);
  return network;
}

}  // namespace

BarNetwork rigid_network(const Sheet& sheet, double stiffness) {
  BarNetwork network;
  std::set<std::pair<int, int>> pairs;
  for (int f = 0; f < sheet.faces(); ++f) {
    const auto corners = sheet.corners_of(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        pairs.insert(std::minmax(corners[i], corners[j]));
      }
    }
    // The widest triangle carries the others.
    std::array<std::size_t, 3> base{0, 1, 2};
    double widest = 0.0;
    for (std::size_t i = 0; i < corners.size() && corners.size() > 3; ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        for (std::size_t k = j + 1; k < corners.size(); ++k) {
          const double area = std::abs(twice_area(sheet, corners[i], corners[j], corners[k]));
          if (area <= widest) continue;
          widest = area;
          base = {i, j, k};
        }
      }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (std::find(base.begin(), base.end(), i) != base.end()) continue;
      network.planes.push_back({corners[base[0]], corners[base[1]], corners[base[2]], corners[i]});
    }
  }
  add_bars(network, sheet, pairs, 1.0);
  for (Bar& bar : network.bars) bar.stiffness = 1.0;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    Hinge hinge = hinge_of(sheet, e);
    hinge.angle = sheet.fold_angles[std::size_t(e)];
    hinge.stiffness = stiffness * flat_length(sheet, hinge.from, hinge.to);
    network.hinges.push_back(hinge);
  }
  return network;
}

std::vector<double> edge_angles(const Sheet& sheet, const std::vector<Vector3d>& places) {
  std::vector<double> angles(std::size_t(sheet.edges()), 0.0);
  for (int e = 0; e < sheet.edges(); ++e) {
    if (!sheet.is_border(e)) angles[std::size_t(e)] = hinge_angle(hinge_of(sheet, e), places);
  }
  return angles;
}

Simulated simulate(const Sheet& sheet, const SimulateOptions& options) {
  BarNetwork network = options.rigid ? rigid_network(sheet) : elastic_network(sheet, options);
  const auto now = edge_angles(sheet, sheet.folded);
  std::vector<double> start(network.hinges.size(), 0.0), end(start.size(), 0.0);
  std::size_t hinge = 0;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    start[hinge] = now[std::size_t(e)];
    end[hinge++] = options.share * sheet.fold_angles[std::size_t(e)];
  }
  // What is not held gives way, but knows to which side it folds.
  constexpr double loose = 1e-9, towards = 0.1;
  if (!options.held.empty()) {
    for (std::size_t i = 0; i < hinge; ++i) {
      network.hinges[i].stiffness *= loose;
      end[i] *= towards;
    }
  }
  for (const HeldCrease& held : options.held) {
    std::size_t i = 0;
    for (int e = 0; e < held.edge && e < sheet.edges(); ++e) i += sheet.is_border(e) ? 0 : 1;
    if (held.edge < 0 || held.edge >= sheet.edges() || sheet.is_border(held.edge)) {
      throw Error("crease " + std::to_string(held.edge) + ": is no crease; edges run from 0 to " +
                  std::to_string(sheet.edges() - 1) + ", and those of the border do not fold");
    }
    network.hinges[i].stiffness /= loose;
    end[i] = held.angle;
  }
  Simulated result;
  result.places = sheet.folded;
  const bool lies_flat =
      std::all_of(start.begin(), start.end(), [](double angle) { return std::abs(angle) < 1e-6; });
  if (!options.held.empty() && lies_flat) {
    // A flat sheet can begin to fold in several ways: all its own folds together show which.
    constexpr double nudge = 0.05;
    BarNetwork all = network;
    std::size_t i = 0;
    for (int e = 0; e < sheet.edges(); ++e) {
      if (sheet.is_border(e)) continue;
      all.hinges[i].stiffness = 1.0;
      all.hinges[i++].angle = nudge * sheet.fold_angles[std::size_t(e)];
    }
    result.places = relax(all, std::move(result.places), {.rigid = options.rigid}).places;
    const auto nudged = edge_angles(sheet, result.places);
    i = 0;
    for (int e = 0; e < sheet.edges(); ++e) {
      if (!sheet.is_border(e)) start[i++] = nudged[std::size_t(e)];
    }
  }
  const int stages = std::max(options.stages, 1);
  for (int stage = 1; stage <= stages; ++stage) {
    const double share = double(stage) / stages;
    for (std::size_t i = 0; i < hinge; ++i) {
      network.hinges[i].angle = start[i] + share * (end[i] - start[i]);
    }
    const Relaxed relaxed = relax(network, std::move(result.places), {.rigid = options.rigid});
    result.places = relaxed.places;
    result.strain = relaxed.strain;
    result.planarity = relaxed.planarity;
    result.steps += relaxed.steps;
  }
  result.angles = edge_angles(sheet, result.places);
  return result;
}

}  // namespace hada
