#pragma once

#include <bit>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh.h"
#include "io/mesh_file.h"

/// The formats of `io/mesh_file.h`, each between bytes and a mesh. Readers check the syntax and
/// throw Error beginning with `name`; indices and numbers are checked by `read_mesh` for all.
namespace hada {

TriangleMesh mesh_from_obj(std::string_view text, const std::string& name);
TriangleMesh mesh_from_ply(std::string_view bytes, const std::string& name);
/// folder  where buffers lie that the file names
TriangleMesh mesh_from_gltf(std::string_view bytes, const std::string& name,
                            const std::filesystem::path& folder);

std::string obj_of(const TriangleMesh& mesh);
std::string stl_of(const TriangleMesh& mesh);  // binary
std::string ply_of(const TriangleMesh& mesh);  // binary, little endian
/// binary  GLB instead of JSON with the buffer inside
std::string gltf_of(const TriangleMesh& mesh, const MeshLook& look, bool binary);

/// Adds the bytes of `value` as both binary formats want them, little end first.
template <class Value>
void append(std::string& bytes, const Value& value) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace hada
