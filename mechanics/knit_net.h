#pragma once

#include <vector>

#include <Eigen/Core>

namespace hada {

/// A knit as mass points and springs: one point for each stitch, a spring to each of its four
/// neighbours.
///
/// Points are counted along the courses, course after course: `course * wales + wale`. The spring
/// to the next stitch of the course, and the one up to the next course, are of the course's own
/// yarn, whose loop makes both. A point is therefore of one of four kinds, by its own yarn and that
/// of the course below. A yarn runs on along its course, so that its tension is handed on:
///
///   F_i = sum_j k (|r_ij| - l) u_ij                         eq. 1
///       + c sum_j k (|r_jk| - l) u_ij, i j k along a yarn   eq. 2
///
/// with r_ij = x_j - x_i and u its direction. Eq. 2 has no energy: it is a force without a
/// counterforce.
///
/// Source: Sakaguchi and Miyata, IPSJ CG-150 no. 5 (2013), section 5.
struct KnitNet {
  int courses = 0;
  int wales = 0;
  bool round = false;             // a tube: the last wale is followed by the first
  double wale_length = 1.0;       // of a spring along a course at rest: one wale to the next
  double course_length = 1.0;     // of a spring between courses at rest
  std::vector<double> stiffness;  // k of the yarn of each course
  double continuity = 0.2;        // c, the paper's yarn coefficient
  std::vector<bool> pinned;       // points that stay; empty: none

  int points() const { return courses * wales; }
  bool is_pinned(int point) const { return !pinned.empty() && pinned[std::size_t(point)]; }
};

/// The stiffness of each course when nylon (1) and support yarn (`ratio`) follow `repeat`, upward:
/// 0 nylon, else support. The paper's: ratio 10, {0, 1}.
std::vector<double> stiffness_of_courses(int courses, double ratio,
                                         const std::vector<int>& repeat = {0, 1});

using Places = std::vector<Eigen::Vector3d>;

/// The length of the longest vector; infinite if one of them is not finite.
double longest(const Places& vectors);

/// Length, direction and tension of every spring. A spring that is missing at a border has none.
struct KnitSprings {
  Places along, up;  // unit directions: to the next wale, to the next course
  std::vector<double> along_length, up_length;
  std::vector<double> along_tension, up_tension;  // > 0 where it pulls
};
KnitSprings springs_of(const KnitNet& net, const Places& places);
double largest_tension(const KnitSprings& springs);

/// The force on every point, those that are pinned too.
Places forces(const KnitNet& net, const KnitSprings& springs);
/// The part of it that the continuity of the yarn adds, over c: the derivative with respect to c.
Places continuity_forces(const KnitNet& net, const KnitSprings& springs);

/// How the forces change when the points move by `way`: the Jacobian's product with it.
Places force_changes(const KnitNet& net, const KnitSprings& springs, const Places& way);

}  // namespace hada
