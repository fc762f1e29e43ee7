#pragma once

#include <vector>

#include "mechanics/knit_frames.h"

namespace hada {

/// A spring of a knitted shell: a piece of yarn between two stitches.
struct ShellSpring {
  int from = 0, to = 0;
  int course = 0;               // whose yarn it is of
  int before = -1, after = -1;  // the springs that its yarn comes from and runs on to
};

/// A knit of any shape as mass points and springs: where its courses end or grow narrower, stitches
/// have other neighbours than in a `KnitNet`. The forces are the same,
///
///   F_i = sum_j k (|r_ij| - l) u_ij
///       + c sum_j k (|r_jk| - l) u_ij, i j k along a yarn
///
/// but that yarn which is slack buckles: it pushes with a hundredth of its stiffness. Shells are
/// never taut everywhere, and with springs that push they would fold where yarn lies loose.
struct ShellNet {
  std::vector<int> course, wale;     // of each point
  std::vector<ShellSpring> springs;  // along the yarns first, then from each course to the next
  int along = 0;                     // so many run along the yarns
  double wale_length = 1.0;          // of a spring along a yarn at rest
  double course_length = 1.0;        // of the others
  std::vector<double> stiffness;     // k of the yarn of each course
  double continuity = 0.2;           // c
  std::vector<bool> pinned;          // points that stay; empty: none

  int points() const { return int(course.size()); }
  bool is_pinned(int point) const { return !pinned.empty() && pinned[std::size_t(point)]; }
  /// Of the yarn of a spring.
  double k(int spring) const { return stiffness[std::size_t(springs[std::size_t(spring)].course)]; }
};

/// Of each spring: unit direction, length, tension (> 0 where it pulls), and the stiffness that it
/// has at this length.
struct ShellSprings {
  Places directions;
  std::vector<double> length, tension, stiffness;
};
ShellSprings springs_of(const ShellNet& net, const Places& places);
double largest_tension(const ShellSprings& springs);

/// The force on every point, those that are pinned too.
Places forces(const ShellNet& net, const ShellSprings& springs);

/// How the forces change when the points move by `way`.
Places force_changes(const ShellNet& net, const ShellSprings& springs, const Places& way);

/// A stitch, the next one of its course and what lies between them and the course above: a face of
/// the net. Four corners where both go on, three where they are knitted together or where a yarn is
/// wrapped around a stitch beside it.
struct ShellCell {
  std::vector<int> corners;
  std::vector<int> springs;  // its sides
  int along = 0;             // a spring of each kind beside it
  int up = 0;
};
std::vector<ShellCell> cells_of(const ShellNet& net);

}  // namespace hada
