#pragma once

#include "fit/knit_photographs.h"
#include "mechanics/knit_rest.h"
#include "synth/knit_photograph.h"

namespace hada {

/// Photographs of a knit of blue nylon and yellow support yarn, made three times finer than seen.
struct MadePhotographs {
  double pitch = 0.13;  // mm
  int side = 8;         // courses and wales of the piece
  Seed seed = 1;

  Knit<> knit() const {
    Knit<> knit;
    knit.wale_mm = 2.0, knit.course_mm = 1.5, knit.yarn_radius_mm = 0.3, knit.loop_depth_mm = 0.24;
    knit.colour_repeat = {0.0, 1.0};
    knit.yarns = {{0.15, 0.25, 0.4}, {0.7, 0.6, 0.3}};
    return knit;
  }
  KnitNet net(int courses, double ratio) const {
    KnitNet net;
    net.courses = net.wales = courses;
    net.wale_length = 2.0, net.course_length = 1.5;
    net.stiffness = stiffness_of_courses(courses, ratio);
    return net;
  }
  Surface seen(const BentKnit& bent, int rows, int cols, Seed key) const {
    Surface surface;
    surface.extent = {rows, cols, pitch, Unit::mm};
    surface.mask = full_mask(surface.extent);
    surface.albedo = knit_photograph(knit(), bent, surface.extent, 100 * seed + key);
    return surface;
  }
  Surface rest() const {
    const auto flat = pulled(net(22, 10.0), KnitPull::wale, KnitClamp::uniform, 1.0);
    return seen({22, 22, flat.start}, int(27.0 / pitch), int(36.0 / pitch), 1);
  }
  /// At rest under both forces, shifted and turned a little.
  BentKnit piece(double ratio, double stretch, double turn = 0.0, double shift = 0.0) const {
    const auto knit = pulled(net(side, ratio), KnitPull::wale, KnitClamp::three_points, stretch);
    Places places = knit_at_rest(knit.net, knit.start).places;
    for (auto& p : places) {
      p = Eigen::Vector3d(std::cos(turn) * p.x() - std::sin(turn) * p.y() + shift,
                          std::sin(turn) * p.x() + std::cos(turn) * p.y() - shift, 0.0);
    }
    return {side, side, places};
  }
  Surface pulled_piece(const BentKnit& bent, double stretch, Seed key) const {
    return seen(bent, int((1.5 * stretch * side + 6.0) / pitch), int((2.0 * side + 8.0) / pitch),
                key);
  }
};

}  // namespace hada
