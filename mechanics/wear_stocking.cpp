#include "mechanics/wear_stocking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "mechanics/foot_path.h"
#include "mechanics/shell_newton.h"

namespace hada {
namespace {

using Eigen::Vector3d;

double course_mm(const FootPath& path, const WearOptions& o) {
  return (path.leg_mm() + path.foot_mm() + path.toe_mm()) / o.courses;
}

StockingShape shape_for(const FootPath& path, const WearOptions& o) {
  const double apart = course_mm(path, o);
  StockingShape shape;
  shape.wales = o.wales;
  shape.heel = 2 * std::max(1, int(std::lround(0.5 * path.heel_mm() / apart - 0.5)));
  shape.foot = std::max(2, int(std::lround(path.foot_mm() / apart)));
  shape.toe = std::max(3, int(std::lround(path.toe_mm() / apart)));
  shape.leg = std::max(2, o.courses - shape.foot - shape.toe);
  return shape;
}

// Where the points begin: rounds in sections, those of a wale of the heel evenly around it.
std::vector<MeshPlace> drawn_on(const FootPath& path, const StockingShape& shape,
                                const ShellNet& net) {
  std::vector<int> rows(std::size_t(shape.wales), 0), passed = rows;
  const auto is_heel = [&](int course) {
    return course >= shape.leg && course < shape.leg + shape.heel;
  };
  for (int i = 0; i < net.points(); ++i) {
    rows[std::size_t(net.wale[std::size_t(i)])] += is_heel(net.course[std::size_t(i)]);
  }
  std::vector<MeshPlace> places;
  LimbSection section;
  int of_course = -1;
  for (int i = 0; i < net.points(); ++i) {
    const int course = net.course[std::size_t(i)];
    const auto wale = std::size_t(net.wale[std::size_t(i)]);
    const double turn = 2.0 * std::numbers::pi * double(wale) / shape.wales;
    const int foot = course - shape.leg - shape.heel, toe = foot - shape.foot;
    if (toe >= 0) {
      places.push_back(path.toe((toe + 1.0) / (shape.toe + 1.0), turn));
      continue;
    }
    if (is_heel(course)) {
      section = path.heel(++passed[wale] / (rows[wale] + 1.0));
    } else if (course != of_course) {
      section =
          foot < 0 ? path.leg(course / (shape.leg - 1.0)) : path.foot(foot / (shape.foot + 0.0));
    }
    of_course = course;
    places.push_back(path.place(section, turn));
  }
  return places;
}

void describe(WornKnit& worn, const ShellSprings& springs) {
  const ShellNet& net = *worn.shell;
  const auto n = std::size_t(net.points());
  std::vector<int> along(n, 0), up(n, 0);
  worn.wale_mm.assign(n, 0.0), worn.course_mm.assign(n, 0.0), worn.area_mm2.assign(n, 0.0);
  for (std::size_t k = 0; k < net.springs.size(); ++k) {
    const auto& spring = net.springs[k];
    worn.slack += springs.tension[k] < 0.0;
    for (const int end : {spring.from, spring.to}) {
      const auto p = std::size_t(end);
      if (int(k) < net.along) {
        worn.wale_mm[p] += springs.length[k], ++along[p];
      } else {
        worn.course_mm[p] += springs.length[k], ++up[p];
      }
    }
  }
  for (std::size_t p = 0; p < n; ++p) {
    worn.course_mm[p] /= std::max(up[p], 1);
    // The tip is held together by the springs of wales alone.
    worn.wale_mm[p] = along[p] > 0 ? worn.wale_mm[p] / along[p] : worn.course_mm[p];
  }
  for (const ShellCell& cell : cells_of(net)) {
    const auto corner = [&](std::size_t c) { return worn.places[std::size_t(cell.corners[c])]; };
    double area = 0.0;
    for (std::size_t c = 2; c < cell.corners.size(); ++c) {
      area += 0.5 * (corner(c - 1) - corner(0)).cross(corner(c) - corner(0)).norm();
    }
    for (const int c : cell.corners) {
      worn.area_mm2[std::size_t(c)] += area / double(cell.corners.size());
    }
  }
}

}  // namespace

StockingShape stocking_for(const Body& body, const WearOptions& options) {
  return shape_for(FootPath(body, options.axis, options.to_mm), options);
}

WornKnit worn_stocking(const Body& body, const WearOptions& options) {
  expect_wearable(options);
  const FootPath path(body, options.axis, options.to_mm);
  const StockingShape shape = shape_for(path, options);
  WornKnit result;
  result.shell = stocking_net(shape);
  ShellNet& net = *result.shell;
  net.wale_length = options.girth * path.girth_mm() / shape.wales;
  net.course_length = options.length * course_mm(path, options);
  net.stiffness = stiffness_of_courses(net.course.back() + 1, options.ratio, options.repeat);
  net.continuity = options.continuity;
  net.pinned.assign(net.course.size(), false);
  std::fill_n(net.pinned.begin(), shape.wales, true);
  net.pinned.back() = true;
  double longest = course_mm(path, options);
  if (options.friction > 0.0)
    longest = std::min(longest, rough_slide * options.girth * path.girth_mm());
  describe(result, laid_to_rest(result, body, net, ShellNewton(), drawn_on(path, shape, net),
                                {.longest_mm = longest,
                                 .each = true,
                                 .friction = options.friction,
                                 .most_steps = options.most_steps,
                                 .tolerance = options.tolerance}));
  return result;
}

}  // namespace hada
