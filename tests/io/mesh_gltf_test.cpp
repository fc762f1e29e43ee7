#include <string>

#include <gtest/gtest.h>

#include "tests/io/meshes.h"

namespace hada {
namespace {

TEST(GltfFile, IsReadWithTheTransformsOfItsNodes) {
  const TemporaryFolder folder;
  write_mesh(folder / "m.gltf", pyramid());
  std::string text = bytes_of(folder / "m.gltf");
  const std::string node = "\"mesh\": 0";
  const std::size_t at = text.find(node);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, node.size(), node + R"(, "translation": [1, 0, 0], "scale": [2, 2, 2])");
  const TriangleMesh mesh = read_text("m.gltf", text);
  EXPECT_EQ(mesh.vertices_mm[2], Eigen::Vector3d(1000, 4000, 0));
}

}  // namespace
}  // namespace hada
