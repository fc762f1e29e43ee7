#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sheet/pointer.h"
#include "sheet/sheet.h"
#include "sheet/stack.h"

namespace hada {

/// A straight piece in space.
using Stretch = std::array<Eigen::Vector3d, 2>;

/// The directions that divide the corners of a face into `parts`, each as far as the face goes.
std::vector<Stretch> guides_of(const Sheet& sheet, int face, int parts);

/// The places where stretches that lie in one plane cross.
std::vector<Eigen::Vector3d> crossings_of(const std::vector<Stretch>& stretches);

struct AimOptions {
  int edge_parts = 2;                         // in which edges are divided
  int corner_parts = 4;                       // in which corners are
  double reach = 0.02;                        // of a snap, from the line of sight
  std::vector<Stretch> lines = {};            // on the sheet that are no edges yet
  std::optional<Eigen::Vector3d> start = {};  // where the stroke began
  std::vector<int> faces = {};  // if any, their corners, edges and guides count, however deep they
                                // lie, and those of the face that is seen do not
};

/// What a pointer was drawn to.
enum class Drawn { vertex, crossing, division, direction, paper, ground };

struct Aim {
  Eigen::Vector3d place{0.0, 0.0, 0.0};
  Drawn by = Drawn::ground;
  int face = -1;                     // under it, or that it belongs to; -1 beside the paper
  std::vector<Stretch> guides = {};  // to be shown: directions of a corner, lines that cross
  std::vector<Eigen::Vector3d> points = {};  // the divisions of the edge
};

/// Where a pointer means to draw: the vertex within reach, or else the nearest of the points that
/// divide an edge and the places where guides, edges and lines cross, or else the nearest place on
/// a direction that divides the corner, or the half turn at the edge, where the stroke began (also
/// beyond the paper), or else the paper under it, or the ground at the height of the start.
///
/// none  if the ray misses the ground too
///
/// Source: Furuta, Mitani, Fukui, IPSJ Journal 48(12), 2007, figure 6; crossings are ours.
std::optional<Aim> aim(const Sheet& sheet, const Stack& stack, const Ray& ray,
                       const AimOptions& options = {});

}  // namespace hada
