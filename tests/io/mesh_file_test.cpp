#include "io/mesh_file.h"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/io/meshes.h"

namespace hada {
namespace {

using testing::HasSubstr;

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
