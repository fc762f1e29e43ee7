#pragma once

#include "core/fold.h"
#include "core/mesh.h"
#include "io/mesh_file.h"

namespace hada {

/// The faces of a frame as triangles, in the frame's own unit taken as mm; `uv` is the place on the
/// sheet where that is given.
TriangleMesh mesh_of(const FoldFrame& frame);

}  // namespace hada
