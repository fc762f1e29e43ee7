#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sheet/crease.h"
#include "sheet/sheet.h"

/// What a pointer over the folded sheet means, as functions of rays alone: the page with the mouse
/// and a test call the same. Source of all: Furuta, Mitani, Fukui, IPSJ Journal 48(12), 2007, 3.3.
namespace hada {

/// A line of sight: from the eye through a place on the screen.
struct Ray {
  Eigen::Vector3d eye;
  Eigen::Vector3d way;  // of any length
};

/// Where a ray meets the sheet first.
struct Hit {
  int face = 0;
  Eigen::Vector3d place;
};
std::optional<Hit> hit(const Sheet& sheet, const Ray& ray);
/// Where it meets all its faces, the nearest first.
std::vector<Hit> hits(const Sheet& sheet, const Ray& ray);

/// The triangle that is swept by the rays of a drag from `from` to `to`: what it crosses is
/// creased.
CreaseCut drawn_cut(const Ray& from, const Ray& to, double tolerance = 1e-9);

/// A place that a pointer is drawn to.
struct Snap {
  Eigen::Vector3d place;
  int vertex = -1;  // if it is one
  int edge = -1;    // else the edge that it divides
};
/// The vertex, or else the point dividing an edge of the face into `parts`, that the ray passes
/// within `reach` of.
std::optional<Snap> snapped(const Sheet& sheet, int face, const Ray& ray, double reach, int parts);

/// The directions that divide the angle of a face at one of its corners into `parts`, unit length,
/// in the order from the side that leaves the corner.
std::vector<Eigen::Vector3d> corner_directions(const Sheet& sheet, int face, int corner, int parts);

/// The directions that divide the half turn at any place inside an edge of a face into `parts`,
/// unit length, in the order from the way the edge runs around the face.
std::vector<Eigen::Vector3d> edge_directions(const Sheet& sheet, int face, int half, int parts);

/// The crease about which a face should turn when it is clicked at `click`: of its creases that the
/// plane through click and centre and across the face cuts, the one furthest from the click; -1 if
/// there is none.
int axis_of_click(const Sheet& sheet, int face, const Eigen::Vector3d& click);

/// How far a face is turned about an axis when what was clicked at `click` is dragged to `pointer`:
/// the angle about `along` between both in the plane across the axis. None if that plane is seen
/// edge on.
std::optional<double> angle_of_drag(const Eigen::Vector3d& on_axis, const Eigen::Vector3d& along,
                                    const Eigen::Vector3d& click, const Ray& pointer);

/// Whether the axis lies so nearly across the view that the angle would jump with the pointer: then
/// the view should turn about the line from the centre of the face to the click.
bool should_turn_view(const Eigen::Vector3d& along, const Ray& pointer, double least_sine = 0.3);

}  // namespace hada
