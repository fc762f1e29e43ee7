#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/bar_network.h"
#include "sheet/contact.h"
#include "sheet/sheet.h"

namespace hada {

/// Which crease of a face is turned about, and what goes along.
struct Swing {
  int face = 0;
  int axis = 0;                  // edge of the face
  bool all = true;               // flaps that lie on the face turn with it
  std::vector<int> with = {};    // faces whose flaps turn with it in any case
  std::vector<int> pinned = {};  // faces that stay
  int most_steps = 60;           // of the search in which what is linked follows
  double strain = 1e-9;          // that counts as none
};

/// A sheet while a face swings.
struct Swung {
  Sheet sheet;
  double angle = 0.0;                                // that was reached, radians
  std::optional<std::array<int, 2>> met = {};        // faces that met there, if it is not all
  bool stuck = false;                                // what is linked could not follow further
  std::vector<Eigen::Vector3d> shortly_before = {};  // where vertices were not long before
};

/// A face on its way about one of its creases, as far as no face meets another.
///
/// Where the creases along the axis part the paper, one side of it turns as it is: the other one if
/// a pin holds the first. Where they do not, the faces are linked, and all others move as
/// little as they can and stay stiff; the face beyond the axis stays, or those that are pinned.
class Swinging {
 public:
  /// order   of faces that lie on each other
  /// throws  Error with `where` if the axis is no crease of the face or both sides are pinned
  Swinging(Sheet sheet, Swing swing, const std::vector<FaceOrder>& order, const std::string& where);

  /// Turns it further, by radians about the axis with the face to its left, as far as it goes.
  void further(double angle);

  /// Where it is now. The angle is of all turns, what it met or why it is stuck of the last.
  const Swung& now() const { return now_; }

 private:
  void turn_part(double angle);
  void turn_linked(double angle);
  std::optional<std::vector<Eigen::Vector3d>> led(double angle);

  Swing swing_;
  Swung now_;
  Eigen::Vector3d from_, along_;  // the axis, of unit length, the face to its left
  std::vector<int> creases_;      // on the axis
  std::vector<bool> faces_;       // that turn
  bool other_side_ = false;       // turns instead, the other way
  std::optional<ContactWatch> watch_;
  std::optional<Relaxation> followers_;  // of what is linked
};

}  // namespace hada
