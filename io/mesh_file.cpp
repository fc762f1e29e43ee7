#include "io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "io/mesh_formats.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || fs::is_directory(path)) {
    throw Error(path.string() + ": cannot be read; give the name of a mesh file");
  }
  return bytes;
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending;
}

void check(const TriangleMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) throw Error(name + ": has no triangles; give a mesh with faces");
  const auto finite = [](const auto& place) { return place.allFinite(); };
  if (!std::all_of(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), finite) ||
      !std::all_of(mesh.uv.begin(), mesh.uv.end(), finite)) {
    throw Error(name + ": holds a coordinate that is not finite; export the mesh again");
  }
  const int count = int(mesh.vertices_mm.size());
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      if (corner >= 0 && corner < count) continue;
      throw Error(name + ": a face names vertex " + std::to_string(corner + 1) + " of " +
                  std::to_string(count) + "; export the mesh again");
    }
  }
}

std::string bytes_as(const std::string& ending, const TriangleMesh& mesh, const MeshLook& look,
                     const std::string& name) {
  if (ending == ".obj") return obj_of(mesh);
  if (ending == ".stl") return stl_of(mesh);
  if (ending == ".ply") return ply_of(mesh);
  if (ending == ".gltf") return gltf_of(mesh, look, false);
  if (ending == ".glb") return gltf_of(mesh, look, true);
  throw Error(name + ": meshes are written as .obj, .stl, .ply, .gltf or .glb; choose one of them");
}

}  // namespace

TriangleMesh read_mesh(const fs::path& path) {
  const std::string name = path.string(), ending = ending_of(path), bytes = bytes_of(path);
  TriangleMesh mesh;
  if (ending == ".obj") {
    mesh = mesh_from_obj(bytes, name);
  } else if (ending == ".ply") {
    mesh = mesh_from_ply(bytes, name);
  } else if (ending == ".gltf" || ending == ".glb") {
    mesh = mesh_from_gltf(bytes, name, fs::absolute(path).parent_path());
  } else {
    throw Error(name + ": meshes are read from .obj, .ply, .gltf or .glb; convert it to one");
  }
  check(mesh, name);
  return mesh;
}

void write_mesh(Output& output, const std::string& name, const TriangleMesh& mesh,
                const MeshLook& look) {
  const std::string bytes = bytes_as(ending_of(name), mesh, look, name);
  std::ofstream stream(output.file(name), std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw Error(name + ": cannot be written; check the free space");
}

void write_mesh(const fs::path& path, const TriangleMesh& mesh, const MeshLook& look) {
  write_text(path, bytes_as(ending_of(path), mesh, look, path.string()));
}

}  // namespace hada
