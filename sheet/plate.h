#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sheet/sheet.h"

namespace hada {

/// A face in space: convex, seen from its printed side with corners counter-clockwise.
struct Plate {
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d normal;     // unit length, on the printed side
  Eigen::Vector3d centre;     // mean of the corners
  Eigen::Vector3d low, high;  // of its box
};

Plate plate_of(const std::vector<int>& corners, const std::vector<Eigen::Vector3d>& places);

/// All faces of a sheet, as it lies or with its vertices at other places.
std::vector<Plate> plates_of(const Sheet& sheet);
std::vector<Plate> plates_of(const Sheet& sheet, const std::vector<Eigen::Vector3d>& places);

/// Whether two plates go through each other: each reaches to both sides of the other's plane, and
/// they share a piece of the line between, all by more than `tolerance`. Plates that lie on each
/// other, or touch, do not.
///
/// Source: Moller, A fast triangle-triangle intersection test, J. Graphics Tools 2 (1997).
bool pierce(const Plate& one, const Plate& other, double tolerance);

/// The middle of what two plates have in common where they lie on each other in one plane, within
/// `near` (a length); nothing if they do not.
std::optional<Eigen::Vector3d> common_place(const Plate& one, const Plate& other, double near);

/// A place on a plate, told by its first and last side so that it goes along with the plate.
Eigen::Vector2d mark_on(const Plate& plate, const Eigen::Vector3d& place);
Eigen::Vector3d marked_place(const Plate& plate, const Eigen::Vector2d& mark);

}  // namespace hada
