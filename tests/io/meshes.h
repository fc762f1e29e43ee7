#pragma once

#include <string>

#include "io/mesh_file.h"
#include "tests/io/temporary_folder.h"

namespace hada {

/// A pyramid with an open base and one uv for each vertex; numbers are exact in float and in
/// metres.
inline TriangleMesh pyramid() {
  return {{{0, 0, 1000}, {1000, 0, 0}, {0, 2000, 0}, {-1000, 0, 0}, {0, -500, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}},
          {{0.5, 0.5}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0}}};
}

inline TriangleMesh read_text(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  put(folder / name, bytes);
  return read_mesh(folder / name);
}

inline std::string error_for(const std::string& name, const std::string& bytes) {
  return error_of([&] { read_text(name, bytes); });
}

}  // namespace hada
