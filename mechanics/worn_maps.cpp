#include "mechanics/worn_maps.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace hada {
namespace {

// An even repeat is centred by counting its outermost courses by half.
double weight_of(int step, int repeat) {
  return repeat % 2 == 0 && 2 * std::abs(step) == repeat ? 0.5 : 1.0;
}

// The mean goes up and down the wale of each point; where wales end, from there.
std::vector<double> pressures_of_shell(const WornKnit& knit, int repeat) {
  const ShellNet& net = *knit.shell;
  std::vector<int> above(knit.press.size(), -1), below = above;
  for (std::size_t k = std::size_t(net.along); k < net.springs.size(); ++k) {
    const auto& spring = net.springs[k];
    above[std::size_t(spring.from)] = spring.to;
    int& under = below[std::size_t(spring.to)];
    if (under < 0) under = spring.from;
  }
  std::vector<double> map;
  for (int i = 0; i < net.points(); ++i) {
    std::vector<int> way{i};
    for (const auto* next : {&below, &above}) {
      for (int k = 0; k < repeat / 2 && (*next)[std::size_t(way.back())] >= 0; ++k) {
        way.push_back((*next)[std::size_t(way.back())]);
      }
      std::reverse(way.begin(), way.end());
    }
    // From the top down now, the point in it somewhere; near an end on one side of it only.
    double force = 0.0, area = 0.0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      const bool outermost = k == 0 || k + 1 == way.size();
      const double weight =
          outermost && int(way.size()) == repeat + 1 ? weight_of(repeat / 2, repeat) : 1.0;
      force += weight * knit.press[std::size_t(way[k])];
      area += weight * knit.area_mm2[std::size_t(way[k])];
    }
    map.push_back(force / std::max(area, 1e-300));
  }
  return map;
}

}  // namespace

std::vector<double> densities(const WornKnit& knit) {
  std::vector<double> map;
  for (const double area : knit.area_mm2) map.push_back(1.0 / std::max(area, 1e-300));
  return map;
}

std::vector<double> pressures(const WornKnit& knit, int repeat) {
  if (knit.shell) return pressures_of_shell(knit, repeat);
  const int courses = knit.net.courses, wales = knit.net.wales;
  std::vector<double> map;
  const int half = repeat / 2;
  for (int i = 0; i < courses * wales; ++i) {
    // At the cuffs the nearest whole repeat stands for what is not there.
    const int middle =
        courses > 2 * half ? std::clamp(i / wales, half, courses - 1 - half) : i / wales;
    double force = 0.0, area = 0.0;
    for (int step = -half; step <= half; ++step) {
      const int course = std::clamp(middle + step, 0, courses - 1);
      const double weight = weight_of(step, repeat);
      const auto p = std::size_t(course * wales + i % wales);
      force += weight * knit.press[p], area += weight * knit.area_mm2[p];
    }
    map.push_back(force / std::max(area, 1e-300));
  }
  return map;
}

double see_through(double wale_mm, double course_mm, double radius_mm, const Eigen::Vector3d& along,
                   const Eigen::Vector3d& up, const Eigen::Vector3d& normal,
                   const Eigen::Vector3d& view) {
  const double facing = std::abs(normal.dot(view));
  // Lines a distance apart on a tilted plane look that far apart times area over length as seen.
  const auto gap = [&](double distance, const Eigen::Vector3d& yarn) {
    const double seen = distance * facing / std::max(view.cross(yarn).norm(), 1e-12);
    return std::max(0.0, 1.0 - 2.0 * radius_mm / std::max(seen, 1e-300));
  };
  return gap(wale_mm, up) * gap(course_mm, along);
}

std::vector<double> transmittances(const WornKnit& knit, double radius_mm) {
  std::vector<double> map;
  for (std::size_t i = 0; i < knit.places.size(); ++i) {
    map.push_back(see_through(knit.wale_mm[i], knit.course_mm[i], radius_mm,
                              Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                              Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()));
  }
  return map;
}

}  // namespace hada
