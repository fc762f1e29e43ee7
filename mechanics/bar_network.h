#pragma once

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace hada {

/// A bar between two points: energy k (length - rest)^2 / 2.
struct Bar {
  int from = 0;
  int to = 0;
  double length = 0.0;
  double stiffness = 1.0;
};

/// Two facets that turn about the line from `from` to `to`: energy k (angle - rest)^2 / 2.
struct Hinge {
  int from = 0;
  int to = 0;
  int left = 0;        // a corner of the facet to the left of the line
  int right = 0;       // and of the one to the right
  double angle = 0.0;  // radians, at rest; positive where both corners rise towards the viewer
  double stiffness = 1.0;
};

/// The angle between two sides of a facet: energy k (angle - rest)^2 / 2.
struct Corner {
  int at = 0;
  int from = 0;
  int to = 0;
  double angle = 0.0;  // radians
  double stiffness = 1.0;
};

/// Bars and hinges between points, and fours of points that lie in a plane.
struct BarNetwork {
  std::vector<Bar> bars;
  std::vector<Hinge> hinges;
  std::vector<Corner> corners;  // of facets that are not rigid
  std::vector<std::array<int, 4>> planes;
  std::vector<bool> pinned;  // points that stay; empty: none
};

/// How far two facets are turned about their line, in (-pi, pi]; 0 where they are flat.
double hinge_angle(const Hinge& hinge, const std::vector<Eigen::Vector3d>& places);

struct RelaxOptions {
  bool rigid = true;  // bars keep their length and planes stay flat whatever hinges want
  int most_steps = 200;
  double tolerance = 1e-11;  // of a step, share of the longest bar, where the search ends
};

struct Relaxed {
  std::vector<Eigen::Vector3d> places;
  double strain = 0.0;     // largest change of a bar, share of its length
  double planarity = 0.0;  // largest distance of a point from the plane of its three others, share
                           // of the longest bar
  int steps = 0;
};

/// The search for the points at rest: the least energy, by Levenberg and Marquardt's descent with a
/// sparse factorisation. What depends on the network alone is worked out once, at the first search.
///
/// Rigid: bars are made stiffer than hinges step by step until they hardly change, and what is left
/// is taken off by a descent of bars and planes alone, which moves the points as little as
/// possible.
class Relaxation {
 public:
  explicit Relaxation(BarNetwork network, const RelaxOptions& options = {});
  Relaxation(Relaxation&&) noexcept;
  Relaxation& operator=(Relaxation&&) noexcept;
  ~Relaxation();

  /// The points at rest, reached from `start`.
  Relaxed from(std::vector<Eigen::Vector3d> start);

 private:
  class Descent;
  std::unique_ptr<Descent> descent_;
  RelaxOptions options_;
};

/// One such search.
Relaxed relax(const BarNetwork& network, std::vector<Eigen::Vector3d> start,
              const RelaxOptions& options = {});

}  // namespace hada
