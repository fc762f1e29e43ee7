#include "app/sheet_mesh.h"

#include "sheet/stack.h"

namespace hada {
namespace {

double extent_of(const FoldFrame& frame) {
  Eigen::Vector3d low = frame.vertices.at(0), high = low;
  for (const auto& p : frame.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

}  // namespace

double paper_thickness(const FoldFrame& frame) {
  return frame.vertices.empty() ? 0.0 : extent_of(frame) / 2000.0;
}

TriangleMesh mesh_of(const FoldFrame& frame, double thickness) {
  TriangleMesh mesh;
  std::vector<Plate> plates;
  for (const auto& face : frame.faces) plates.push_back(plate_of(face, frame.vertices));
  const bool layered = thickness > 0.0 && !frame.face_orders.empty();
  if (!layered) mesh.vertices_mm = frame.vertices;
  const Stack stack = layered ? stack_of(plates, frame.face_orders, extent_of(frame)) : Stack{};
  for (std::size_t f = 0; f < frame.faces.size(); ++f) {
    std::vector<int> corners = frame.faces[f];
    for (std::size_t i = 0; layered && i < corners.size(); ++i) {
      corners[i] = int(mesh.vertices_mm.size());
      mesh.vertices_mm.push_back(plates[f].corners[i] + thickness * stack.level[f] * stack.up[f]);
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
  }
  return mesh;
}

}  // namespace hada
