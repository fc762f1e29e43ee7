#include "app/sheet_mesh.h"

#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "app/fold_log_file.h"
#include "app/fold_model.h"

namespace hada {
namespace {

// Where the first corner of each face lies, above the frame's place of it.
std::vector<double> lifts(const FoldFrame& frame, const TriangleMesh& mesh) {
  std::vector<double> lifts;
  std::size_t first = 0;
  for (const auto& face : frame.faces) {
    lifts.push_back((mesh.vertices_mm[first] - frame.vertices[std::size_t(face[0])]).z());
    first += face.size();
  }
  return lifts;
}

TEST(SheetMesh, LiftsLayersInTheirOrder) {
  const auto log = std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic/folds/snail.json";
  const FoldFrame frame = fold_model("", replayed(read_fold_log(log)).back()).frames[0];
  constexpr double thickness = 0.001;
  const TriangleMesh mesh = mesh_of(frame, thickness);
  const auto lift = lifts(frame, mesh);
  ASSERT_GT(frame.face_orders.size(), 1000u);
  for (const FaceOrder& o : frame.face_orders) {
    // The print of a face is up where its corners run counter-clockwise.
    double area = 0.0;
    const auto& face = frame.faces[std::size_t(o.other)];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto &a = frame.vertices[std::size_t(face[i])],
                 &b = frame.vertices[std::size_t(face[(i + 1) % face.size()])];
      area += a.x() * b.y() - a.y() * b.x();
    }
    const double above = lift[std::size_t(o.face)] - lift[std::size_t(o.other)];
    EXPECT_GT(above * o.order * (area > 0.0 ? 1.0 : -1.0), 0.99 * thickness);
  }
}

TEST(SheetMesh, KeepsSharedCornersWithoutThickness) {
  FoldFrame frame;
  frame.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  frame.faces = {{0, 1, 2, 3}, {3, 2, 1}};
  frame.face_orders = {{0, 1, 1}};
  EXPECT_EQ(mesh_of(frame, 0.0).vertices_mm, frame.vertices);
  EXPECT_EQ(mesh_of(frame, paper_thickness(frame)).vertices_mm.size(), 7u);
  EXPECT_EQ(paper_thickness(frame), 0.001);
  EXPECT_EQ(mesh_of(frame, 0.1).triangles.size(), 3u);
}

}  // namespace
}  // namespace hada
