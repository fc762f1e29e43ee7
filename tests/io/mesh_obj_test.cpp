#include <array>

#include <gtest/gtest.h>

#include "tests/io/meshes.h"

namespace hada {
namespace {

TEST(ObjFile, IsReadAsOthersWriteIt) {
  const TriangleMesh mesh = read_text("m.obj",
                                      "# a square\r\nmtllib m.mtl\r\no square\r\n"
                                      "v 0 0 0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 0\r\nv 0 1e0 0\r\n"
                                      "vt 0 0 0\r\nvt 1 1\r\nvn 0 0 1\r\n"
                                      "f 1//1 2//1 3//1 4//1\r\nf -4/1/1 -3/2/1 -2/2/1\r\n");
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.triangles[1], (std::array<int, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.vertices_mm.size(), 7u);  // the last face has uv, so its corners are other ones
  EXPECT_EQ(mesh.uv[5], Eigen::Vector2d(1, 1));
}

}  // namespace
}  // namespace hada
