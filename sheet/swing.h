#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Which crease of a face is turned about, and what goes along.
struct Swing {
  int face = 0;
  int axis = 0;                  // edge of the face
  double angle = 0.0;            // radians, about the axis with the face to its left
  bool all = true;               // flaps that lie on the face turn with it
  std::vector<int> with = {};    // faces whose flaps turn with it in any case
  std::vector<int> pinned = {};  // faces that stay
  int most_steps = 60;           // of the search in which what is linked follows
  double strain = 1e-9;          // that counts as none
};

/// A sheet after a swing.
struct Swung {
  Sheet sheet;
  double angle = 0.0;                                // that was reached, radians
  std::optional<std::array<int, 2>> met = {};        // faces that met there, if it is not all
  std::vector<Eigen::Vector3d> shortly_before = {};  // where vertices were not long before
};

/// The sheet with a face turned about one of its creases, as far as no face meets another.
///
/// Where the creases along the axis part the paper, one side of it turns as it is: the other one if
/// a pin holds the first. Where they do not, the faces are linked, and all others move as
/// little as they can and stay stiff; the face beyond the axis stays, or those that are pinned.
///
/// order   of faces that lie on each other
/// throws  Error with `where` if the axis is no crease of the face, both sides are pinned, or what
///         is linked cannot follow
Swung swung(Sheet sheet, const Swing& swing, const std::vector<FaceOrder>& order,
            const std::string& where);

}  // namespace hada
