#include "io/mesh_file.h"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

// A pyramid with an open base and one uv for each vertex; numbers are exact in float and in metres.
TriangleMesh pyramid() {
  return {{{0, 0, 1000}, {1000, 0, 0}, {0, 2000, 0}, {-1000, 0, 0}, {0, -500, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}},
          {{0.5, 0.5}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0}}};
}

TriangleMesh read_text(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  put(folder / name, bytes);
  return read_mesh(folder / name);
}

std::string error_for(const std::string& name, const std::string& bytes) {
  return error_of([&] { read_text(name, bytes); });
}

class MeshFile : public testing::TestWithParam<std::string> {};

TEST_P(MeshFile, ReturnsWhatWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder / GetParam();
  TriangleMesh mesh = pyramid();
  write_mesh(path, mesh);
  EXPECT_EQ(read_mesh(path), mesh);
  mesh.uv.clear();
  write_mesh(path, mesh);
  EXPECT_EQ(read_mesh(path), mesh);
}

TEST_P(MeshFile, SurvivesCutsAndChangedBytes) {
  const TemporaryFolder folder;
  write_mesh(folder / GetParam(), pyramid());
  const std::string bytes = bytes_of(folder / GetParam());
  int refused = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 13) {
    refused += error_for(GetParam(), bytes.substr(0, at)).empty() ? 0 : 1;
    for (const int flip : {0x01, 0x90}) {
      std::string changed = bytes;
      changed[at] = char(changed[at] ^ flip);
      error_for(GetParam(), changed);  // an Error or a mesh, and never a crash
    }
  }
  // Of 13 cuts and more; an OBJ that ends after one of its faces is a smaller mesh.
  EXPECT_GE(refused, 5);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFile, testing::Values("m.obj", "m.ply", "m.gltf", "m.GLB"),
                         [](const auto& format) { return format.param.substr(2); });

TEST(MeshFile, WritesStlWithNormalsOfTheFaces) {
  const TemporaryFolder folder;
  write_mesh(folder / "m.stl", pyramid());
  const std::string bytes = bytes_of(folder / "m.stl");
  // A header of 80 bytes, a count, and 12 floats with two bytes more for each face.
  EXPECT_EQ(bytes.size(), 84u + 4u * 50u);
  std::array<float, 3> normal{};
  std::copy_n(bytes.data() + 84, sizeof normal, reinterpret_cast<char*>(normal.data()));
  // The first face lies in x + y / 2 + z = 1000: all sides see its outside.
  EXPECT_FLOAT_EQ(normal[0], 2.0f / 3.0f);
  EXPECT_FLOAT_EQ(normal[1], 1.0f / 3.0f);
  EXPECT_FLOAT_EQ(normal[2], 2.0f / 3.0f);
}

TEST(MeshFile, ReadsObjAsOthersWriteIt) {
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

TEST(MeshFile, ReadsPlyOfEitherKind) {
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

TEST(MeshFile, AppliesTheTransformsOfNodes) {
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

TEST(MeshFile, SaysWhatIsWrong) {
  EXPECT_THAT(error_for("m.obj", ""), HasSubstr("has no triangles"));
  EXPECT_THAT(error_for("m.obj", "v 0 0\n"), HasSubstr("line 1: '' should be a number"));
  EXPECT_THAT(error_for("m.obj", "v 0 0 0\nf 1 1 2\n"), HasSubstr("line 2: names number 2 of 1"));
  EXPECT_THAT(error_for("m.obj", "v 0 0 nan\nf 1 1 1\n"), HasSubstr("not finite"));
  EXPECT_THAT(error_for("m.obj", "v 0 0 0\nf 1 1\n"), HasSubstr("three corners"));
  EXPECT_THAT(error_for("m.ply", "ply\n"), HasSubstr("ends within its header"));
  EXPECT_THAT(error_for("m.ply",
                        "ply\nformat ascii 1.0\nelement vertex 99999999999\n"
                        "property float x\nend_header\n1 2 3\n"),
              HasSubstr("ends early"));
  EXPECT_THAT(error_for("m.glb", "glTF"), HasSubstr("no whole glTF"));
  EXPECT_THAT(error_for("m.gltf", "{}"), HasSubstr("m.gltf"));
  EXPECT_THAT(error_for("m.fbx", ""), HasSubstr(".obj, .ply, .gltf or .glb"));
  EXPECT_THAT(error_of([] { read_mesh("/nowhere/m.obj"); }), HasSubstr("/nowhere/m.obj"));
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { write_mesh(folder / "m.fbx", pyramid()); }), HasSubstr(".stl"));
}

}  // namespace
}  // namespace hada
