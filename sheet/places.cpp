#include "sheet/places.h"

#include <Eigen/LU>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// How far along the first and the last side of a face, from its first corner, a place lies.
template <class Sides, class Way>
Vector2d shares(const Sides& sides, const Way& way) {
  return (sides.transpose() * sides).inverse() * (sides.transpose() * way);
}

struct Frame {
  std::size_t corner, first, last;
};

Frame frame_of(const Sheet& sheet, int face) {
  const auto corners = sheet.corners_of(face);
  return {std::size_t(corners[0]), std::size_t(corners[1]), std::size_t(corners.back())};
}

}  // namespace

int face_at(const Sheet& sheet, const Vector2d& flat) {
  const double slack = 1e-9 * size_of(sheet.flat);
  for (int f = 0; f < sheet.faces(); ++f) {
    bool inside = true;
    for (const int h : sheet.halves_of(f)) {
      const Vector2d &a = sheet.flat[std::size_t(sheet.origin(h))],
                     &b = sheet.flat[std::size_t(sheet.target(h))];
      const Vector2d way = (b - a).normalized(), to = flat - a;
      inside = inside && way.x() * to.y() - way.y() * to.x() > -slack;
    }
    if (inside) return f;
  }
  return -1;
}

Vector2d flat_place(const Sheet& sheet, int face, const Vector3d& place) {
  const auto [a, b, c] = frame_of(sheet, face);
  Eigen::Matrix<double, 3, 2> sides;
  sides << sheet.folded[b] - sheet.folded[a], sheet.folded[c] - sheet.folded[a];
  const Vector2d s = shares(sides, Vector3d(place - sheet.folded[a]));
  return sheet.flat[a] + s.x() * (sheet.flat[b] - sheet.flat[a]) +
         s.y() * (sheet.flat[c] - sheet.flat[a]);
}

Vector3d folded_place(const Sheet& sheet, int face, const Vector2d& flat) {
  const auto [a, b, c] = frame_of(sheet, face);
  Eigen::Matrix2d sides;
  sides << sheet.flat[b] - sheet.flat[a], sheet.flat[c] - sheet.flat[a];
  const Vector2d s = shares(sides, Vector2d(flat - sheet.flat[a]));
  return sheet.folded[a] + s.x() * (sheet.folded[b] - sheet.folded[a]) +
         s.y() * (sheet.folded[c] - sheet.folded[a]);
}

}  // namespace hada
