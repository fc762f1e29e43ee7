#pragma once

#include <filesystem>
#include <string>

#include "core/mesh.h"
#include "io/output.h"

namespace hada {

/// A mesh from an OBJ, PLY, glTF or GLB file, in the frame of the file; polygons become fans of
/// triangles.
///
/// OBJ and PLY tell no unit and are taken to be in mm; glTF is in metres by its specification and
/// comes back in mm, with the transforms of its nodes applied. Of glTF only triangles are read.
///
/// throws  Error naming the file if it cannot be read, ends early, is not of its format, refers to
///         a vertex that it does not have, holds a number that is not finite, or has no triangle
TriangleMesh read_mesh(const std::filesystem::path& path);

/// How a mesh looks, as far as glTF can say it: names of pictures beside the file ("" for none)
/// and the two factors of its material.
struct MeshLook {
  std::string base_color, normal, metallic_roughness;
  double metallic = 0.0;
  double roughness = 0.6;
  bool see_through = false;  // the opacity is in the alpha of `base_color`
};

/// Puts `mesh` into `output` as the ending of `name` says: .obj, .stl, .ply, .gltf or .glb.
///
/// Numbers have the precision of float. glTF is written in metres and alone keeps `look`; STL keeps
/// no uv.
///
/// throws  Error for another ending
void write_mesh(Output& output, const std::string& name, const TriangleMesh& mesh,
                const MeshLook& look = {});

/// The same for a single file.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshLook& look = {});

}  // namespace hada
