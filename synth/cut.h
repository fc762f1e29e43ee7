#pragma once

#include <array>
#include <cstddef>

namespace hada {

/// A place in the stem, or a direction there, in the frame of `Wood`.
using StemVector = std::array<double, 3>;

/// A plane that a stem is cut along, as it is looked at.
struct Cut {
  StemVector origin{0.0, 0.0, 0.0};  // where the centre of the picture lies
  StemVector right{1.0, 0.0, 0.0};   // unit vectors, at right angles
  StemVector up{0.0, 1.0, 0.0};

  /// The place in the stem of (x, y) in the picture.
  StemVector at(double x, double y) const {
    StemVector place;
    for (std::size_t k = 0; k < 3; ++k) place[k] = origin[k] + x * right[k] + y * up[k];
    return place;
  }
  StemVector towards_eye() const;
};

/// The cut through `origin` with the directions made unit vectors at right angles; `right` is kept.
///
/// throws  Error if they do not span a plane
Cut cut_along(const StemVector& origin, const StemVector& right, const StemVector& up);

}  // namespace hada
