#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanics/bar_network.h"
#include "sheet/sheet.h"

namespace hada {

/// A crease that is held at an angle, radians: valleys > 0, mountains < 0.
struct HeldCrease {
  int edge = 0;
  double angle = 0.0;
};

struct SimulateOptions {
  double share = 1.0;                 // of each crease's own angle that it is driven to
  std::vector<HeldCrease> held = {};  // if any: these alone are driven, the others follow
  bool rigid = true;                  // false: paper that stretches and bends in its faces a little
  int stages = 20;                    // from the start to the end
  double axial_stiffness = 20.0;      // of paper that stretches: force at a strain of 1
  double fold_stiffness = 0.7;        // torque for each unit of length and radian
  double facet_stiffness = 0.7;       // the same within faces, which are cut into triangles
  double corner_stiffness = 0.2;      // of the corners of triangles, in a sheet of radius 1
};

struct Simulated {
  std::vector<Eigen::Vector3d> places;
  std::vector<double> angles;  // of the edges, radians
  double strain = 0.0;
  double planarity = 0.0;
  int steps = 0;
};

/// The sheet with its creases driven from where it is now (`folded`).
///
/// Rigid faces keep their shape to rounding: where the creases' angles disagree with that, the
/// least sum of length times squared difference is found. Otherwise triangles of bars and hinges
/// come to rest as the simulator of Ghassaei has them.
///
/// throws  Error if a held crease is none
///
/// Source: Ghassaei, Demaine, Gershenfeld, Fast, interactive origami simulation using GPU
/// computation, Origami 7 (2018).
Simulated simulate(const Sheet& sheet, const SimulateOptions& options = {});

/// The faces as bars between all corners and planes, and the creases as hinges at their present
/// angle targets, stiffness times length.
BarNetwork rigid_network(const Sheet& sheet, double stiffness = 1.0);

/// The angles of all edges of a sheet in space; 0 at the border.
std::vector<double> edge_angles(const Sheet& sheet, const std::vector<Eigen::Vector3d>& places);

}  // namespace hada
