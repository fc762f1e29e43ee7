#include "app/sheet_mesh.h"

namespace hada {

TriangleMesh mesh_of(const FoldFrame& frame) {
  TriangleMesh mesh;
  mesh.vertices_mm = frame.vertices;
  for (const auto& face : frame.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      mesh.triangles.push_back({face[0], face[i], face[i + 1]});
    }
  }
  return mesh;
}

}  // namespace hada
