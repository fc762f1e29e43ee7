#include "sheet/unfold.h"

#include <cmath>
#include <map>
#include <vector>

#include <Eigen/Geometry>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The faces of a frame in space that has none: those of its edges seen from above.
FoldFrame with_faces_from_above(const FoldFrame& frame, const std::string& where) {
  FoldFrame above = frame;
  for (Vector3d& vertex : above.vertices) vertex.z() = 0.0;
  const FoldFrame flat = flat_frame(sheet_of(above, where));
  FoldFrame result = flat;
  // Vertices were numbered anew: each is where it was.
  for (Vector3d& vertex : result.vertices) {
    double nearest = 1e300;
    Vector3d found = vertex;
    for (const Vector3d& old : frame.vertices) {
      const double distance = (old - vertex).head<2>().norm();
      if (distance >= nearest) continue;
      nearest = distance;
      found = old;
    }
    vertex = found;
  }
  return result;
}

}  // namespace

Sheet unfolded_sheet(const FoldFrame& given, const std::string& where) {
  const FoldFrame frame = given.faces.empty() ? with_faces_from_above(given, where) : given;
  std::map<std::pair<int, int>, int> face_at;  // the face to the left of a side
  for (std::size_t f = 0; f < frame.faces.size(); ++f) {
    const auto& face = frame.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      face_at[{face[i], face[(i + 1) % face.size()]}] = int(f);
    }
  }
  std::vector<Vector2d> sums(frame.vertices.size(), Vector2d::Zero());
  std::vector<int> counts(frame.vertices.size(), 0);
  std::vector<bool> reached(frame.faces.size(), false);
  struct Step {
    int face, from, to;  // the side that it was entered by, as it runs in this face
    Vector2d at_from, at_to;
  };
  const auto& first = frame.faces.at(0);
  const double length =
      (frame.vertices[std::size_t(first[1])] - frame.vertices[std::size_t(first[0])]).norm();
  std::vector<Step> queue{{0, first[0], first[1], {0.0, 0.0}, {length, 0.0}}};
  reached[0] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Step step = queue[i];
    const auto& face = frame.faces[std::size_t(step.face)];
    const Vector3d &a = frame.vertices[std::size_t(step.from)],
                   &b = frame.vertices[std::size_t(step.to)];
    Vector3d normal = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      normal += (frame.vertices[std::size_t(face[k])] - frame.vertices[std::size_t(face[0])])
                    .cross(frame.vertices[std::size_t(face[k + 1])] -
                           frame.vertices[std::size_t(face[0])]);
    }
    const Vector3d along = (b - a).normalized(), up = normal.cross(along).normalized();
    const Vector2d way = (step.at_to - step.at_from).normalized(), left(-way.y(), way.x());
    std::vector<Vector2d> places;
    for (const int v : face) {
      const Vector3d r = frame.vertices[std::size_t(v)] - a;
      places.push_back(step.at_from + way * r.dot(along) + left * r.dot(up));
      sums[std::size_t(v)] += places.back();
      ++counts[std::size_t(v)];
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      const auto beyond = face_at.find({face[next], face[k]});
      if (beyond == face_at.end() || reached[std::size_t(beyond->second)]) continue;
      reached[std::size_t(beyond->second)] = true;
      queue.push_back({beyond->second, face[next], face[k], places[next], places[k]});
    }
  }
  if (queue.size() < frame.faces.size()) {
    throw Error(where + ": the sheet falls into parts; join them, or give one at a time");
  }
  FoldFrame flat = frame;
  for (std::size_t v = 0; v < flat.vertices.size(); ++v) {
    flat.vertices[v] << sums[v] / std::max(counts[v], 1), 0.0;
  }
  flat.face_orders.clear();
  Sheet sheet = sheet_of(flat, where);
  sheet.folded = frame.vertices;
  return sheet;
}

}  // namespace hada
