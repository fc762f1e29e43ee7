#include "sheet/places.h"

#include <algorithm>

#include <Eigen/LU>

#include "core/error.h"
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

std::vector<int> faces_at(const Sheet& sheet, const std::vector<Vector2d>& places,
                          const std::string& where) {
  std::vector<int> faces;
  for (const Vector2d& place : places) {
    faces.push_back(face_at(sheet, place));
    if (faces.back() < 0) throw Error(where + ": a place lies beside the paper");
  }
  return faces;
}

std::vector<bool> chosen_faces(const Sheet& sheet, const std::vector<Vector2d>& places,
                               const std::string& where) {
  std::vector<bool> chosen;
  if (!places.empty()) chosen.assign(std::size_t(sheet.faces()), false);
  for (const int face : faces_at(sheet, places, where)) chosen[std::size_t(face)] = true;
  return chosen;
}

int first_staying(const std::vector<bool>& moving) {
  return int(std::find(moving.begin(), moving.end(), false) - moving.begin());
}

double distance_to(const Sheet& sheet, int edge, const Vector2d& flat) {
  const Vector2d &a = sheet.flat[std::size_t(sheet.origin(2 * edge))],
                 &b = sheet.flat[std::size_t(sheet.target(2 * edge))];
  const double share = std::clamp((flat - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + share * (b - a) - flat).norm();
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
