#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/extent.h"
#include "core/field.h"
#include "core/random.h"
#include "core/surface.h"

namespace hada {

/// The colour of a yarn, linear.
template <class T = double>
struct KnitYarn {
  T red{0.8};
  T green{0.8};
  T blue{0.8};

  static constexpr auto fields() {
    using F = Field<KnitYarn, T>;
    return std::array{
        F{"red", &KnitYarn::red, 0.0, 4.0, Scale::linear, "", "reflectance, linear"},
        F{"green", &KnitYarn::green, 0.0, 4.0, Scale::linear, "", "reflectance, linear"},
        F{"blue", &KnitYarn::blue, 0.0, 4.0, Scale::linear, "", "reflectance, linear"},
    };
  }
};

/// Plain knit: where its stitches are, how the yarn runs through one, and how it gives.
///
/// A stitch is a loop of the yarn of its course; wales are columns of stitches. In the frame of the
/// fabric (X along the courses, Y up the wales) the yarn of course j is the curve
///   X = place of wale (t / 2 pi + loop_width sin 2t),   Y = place of course j + loop_reach
///   course_mm cos t, z = -loop_depth_mm cos 2t
/// so that heads (t = 0) and feet lie behind and the legs in front. Spacings change linearly over
/// the fabric: at X the wales are wale_mm (1 + wale_gradient_per_mm X) apart.
///
/// Source: the stitch as a mass point with springs, Sakaguchi and Miyata (2013), section 4; the
/// curve is their "curved yarn" left open, in the sinusoidal form of Peirce, Text. Res. J. 17
/// (1947).
template <class T = double>
struct Knit {
  static constexpr std::string_view name = "knit";
  static constexpr std::string_view summary = "plain knit: stitches, yarn and colour repeat";

  T wale_mm{4.0};
  T course_mm{3.2};
  T rotation_rad{0.0};
  T skew_rad{0.0};
  T wale_gradient_per_mm{0.0};
  T course_gradient_per_mm{0.0};
  T wale_phase{0.0};
  T course_phase{0.0};
  T yarn_radius_mm{0.7};
  T loop_width{0.15};
  T loop_reach{0.8};
  T loop_depth_mm{0.55};
  T stiffness_ratio{10.0};
  T yarn_coefficient{0.2};
  std::vector<T> colour_repeat = {T{0.0}};
  std::vector<KnitYarn<T>> yarns = std::vector<KnitYarn<T>>(1);

  static constexpr auto parts() {
    return std::tuple{PartList<Knit, KnitYarn<T>>{"yarns", &Knit::yarns, 1, 8}};
  }
  static constexpr auto lists() {
    return std::tuple{NumberList<Knit, T>{"colour_repeat", &Knit::colour_repeat, 1, 16, 0.0, 7.0,
                                          Scale::linear, "",
                                          "which yarn each course is of, upward, from course 0"}};
  }
  static constexpr auto fields() {
    using F = Field<Knit, T>;
    return std::array{
        F{"wale_mm", &Knit::wale_mm, 1e-2, 1e4, Scale::log, "mm",
          "distance of neighbouring wales along a course, at the origin"},
        F{"course_mm", &Knit::course_mm, 1e-2, 1e4, Scale::log, "mm",
          "distance of neighbouring courses along a wale, at the origin"},
        F{"rotation_rad", &Knit::rotation_rad, -0.8, 0.8, Scale::linear, "rad",
          "direction of the courses, counter-clockwise from +x"},
        F{"skew_rad", &Knit::skew_rad, -0.7, 0.7, Scale::linear, "rad",
          "how far the wales lean from the perpendicular of the courses, counter-clockwise"},
        F{"wale_gradient_per_mm", &Knit::wale_gradient_per_mm, -0.05, 0.05, Scale::linear, "1/mm",
          "relative change of the wale distance along the courses"},
        F{"course_gradient_per_mm", &Knit::course_gradient_per_mm, -0.05, 0.05, Scale::linear,
          "1/mm", "relative change of the course distance up the wales"},
        F{"wale_phase", &Knit::wale_phase, -1.0, 1.0, Scale::linear, "",
          "the origin lies so many wales to the right of the head of a loop"},
        F{"course_phase", &Knit::course_phase, -16.0, 16.0, Scale::linear, "",
          "the origin lies so many courses above the middle of course 0"},
        F{"yarn_radius_mm", &Knit::yarn_radius_mm, 1e-3, 1e3, Scale::log, "mm",
          "radius of the yarn"},
        F{"loop_width", &Knit::loop_width, 0.0, 0.4, Scale::linear, "wales",
          "how far a head swings out beyond its legs"},
        F{"loop_reach", &Knit::loop_reach, 0.3, 1.6, Scale::linear, "courses",
          "height of a head over the middle of its course"},
        F{"loop_depth_mm", &Knit::loop_depth_mm, 0.0, 1e3, Scale::linear, "mm",
          "how far legs lie before, and heads behind, the middle of the fabric"},
        F{"stiffness_ratio", &Knit::stiffness_ratio, 1e-2, 1e3, Scale::log, "",
          "stiffness of support yarn over that of nylon"},
        F{"yarn_coefficient", &Knit::yarn_coefficient, 0.0, 0.95, Scale::linear, "",
          "share of a tension that runs on along the yarn"},
    };
  }
};

/// A place in the frame of the fabric, from (x, y) in the frame of the picture.
template <class T>
std::array<T, 2> fabric_place(const Knit<T>& knit, double x_mm, double y_mm) {
  using std::cos;
  using std::sin;
  const T lean = knit.rotation_rad + knit.skew_rad;
  const T shrink = cos(knit.skew_rad);
  return {(x_mm * cos(lean) + y_mm * sin(lean)) / shrink,
          (y_mm * cos(knit.rotation_rad) - x_mm * sin(knit.rotation_rad)) / shrink};
}

/// How many spacings lie between the origin and `place`, if they change by `gradient` from
/// `spacing`: the inverse of `place_of`.
template <class T>
T count_at(const T& place, const T& spacing, const T& gradient) {
  using std::log;
  const T bend = gradient * place;
  // The series where the quotient loses its digits; its next term is below 1e-15.
  if (bend < 1e-4 && bend > -1e-4) {
    return place / spacing * (1.0 - bend * (0.5 - bend * (1.0 / 3.0 - 0.25 * bend)));
  }
  return log(1.0 + bend) / (gradient * spacing);
}

inline double place_of(double count, double spacing, double gradient) {
  const double bend = gradient * spacing * count;
  return std::abs(bend) < 1e-12 ? spacing * count : std::expm1(bend) / gradient;
}

/// Where (x, y) lies among the stitches: whole numbers are heads of loops, and middles of courses.
template <class T>
std::array<T, 2> stitch_at(const Knit<T>& knit, double x_mm, double y_mm) {
  const auto [x, y] = fabric_place(knit, x_mm, y_mm);
  return {count_at(x, knit.wale_mm, knit.wale_gradient_per_mm) + knit.wale_phase,
          count_at(y, knit.course_mm, knit.course_gradient_per_mm) + knit.course_phase};
}

/// The knit as a surface: height and normals of the yarn, its colour as albedo, black in the holes.
///
/// It tiles: the lattice is bent so that a whole number of stitches and repeats fits each way, by
/// half a stitch over the surface at most, and its gradients are left out.
Surface surface_of(const Knit<>& knit, const Extent& extent, Seed seed);

}  // namespace hada
