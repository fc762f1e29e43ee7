#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/io/meshes.h"

namespace hada {
namespace {

TEST(PlyFile, IsReadOfEitherKind) {
  const std::string header =
      "element vertex 3\ncomment made by hand\nproperty double z\nproperty float x\n"
      "property uchar red\nproperty float y\nelement face 1\nproperty uchar flags\n"
      "property list uchar short vertex_index\nend_header\n";
  const TriangleMesh text = read_text(
      "m.ply", "ply\nformat ascii 1.0\n" + header + "5 1 255 0\n5 0 255 1\n5 0 0 0\n7 3 0 1 2\n");
  EXPECT_EQ(text.vertices_mm[0], Eigen::Vector3d(1, 0, 5));
  std::string bytes = "ply\nformat binary_big_endian 1.0\n" + header;
  const std::string five("\x40\x14\0\0\0\0\0\0", 8), one("\x3f\x80\0\0", 4), zero(4, '\0');
  for (const auto& [x, y] : {std::pair{one, zero}, {zero, one}, {zero, zero}}) {
    bytes += five + x + '\xff' + y;
  }
  bytes += std::string("\x07\x03\0\0\0\x01\0\x02", 8);
  EXPECT_EQ(read_text("m.ply", bytes), text);
}

}  // namespace
}  // namespace hada
