#pragma once

#include <vector>

#include <Eigen/Core>

namespace hada {

/// A straight spring between two points that pulls when it is longer than at rest.
struct Spring {
  int from = 0;
  int to = 0;
  double length = 0.0;  // at rest
};

/// Springs between all pairs of corners of each facet; a pair that facets share has one.
std::vector<Spring> facet_springs(const std::vector<std::vector<int>>& facets,
                                  const std::vector<Eigen::Vector3d>& rest);

struct SpringOptions {
  double damping = 0.2;  // d: share of the force that is taken, and of the speed that is lost
  bool mass_by_springs = false;  // a point weighs as many units as springs meet there, not one
};

/// Points that move under springs, as the paper moves them.
///
///   F_i = sum_j (1 - L_ij / |r_ij|) r_ij;  v += d (F / m - v) dt;  r += v dt;  dt = 1
///
/// Taken literally the paper never loses speed; the term -d v is the reading that settles. It is
/// stable while d lambda dt^2 < 2 (2 - d dt), lambda the largest stiffness over mass; where that
/// fails dt is cut into `substeps`.
///
/// Source: Furuta, Mitani, Fukui, IPSJ Journal 48(12), 2007, eq. 2 to 4.
class SpringMotion {
 public:
  /// pinned  points that stay; empty: none
  SpringMotion(std::vector<Spring> springs, const std::vector<Eigen::Vector3d>& places,
               const std::vector<bool>& pinned, const SpringOptions& options);

  void step(int count);
  std::vector<Eigen::Vector3d> places() const;
  /// The largest change of a spring's length, as a share.
  double strain() const;
  /// How many small steps make one of the paper's: 1 unless that would be unstable.
  int substeps() const { return substeps_; }

 private:
  double largest_stiffness() const;

  std::vector<Spring> springs_;
  std::vector<double> place_, speed_, force_;  // x of all points, then y, then z
  std::vector<double> share_;                  // of a force that moves the point: 1 / mass, or 0
  std::vector<double> way_;                    // of all springs: x, y, z, then the pull
  std::vector<double> rest_;
  double damping_;
  int substeps_ = 1;
};

}  // namespace hada
