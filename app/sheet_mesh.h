#pragma once

#include "core/fold.h"
#include "core/mesh.h"
#include "io/mesh_file.h"

namespace hada {

/// How thick paper is drawn where nobody says: 1 / 2000 of the largest extent of the frame, as a
/// sheet of 20 cm has it.
double paper_thickness(const FoldFrame& frame);

/// The faces of a frame as triangles, in the frame's own unit taken as mm.
///
/// Faces that lie on each other are moved apart by `thickness` for each layer, as the frame orders
/// them, so that none shows through another; their corners are then vertices of their own. Where
/// flaps are tucked into each other in a ring, one of the pairs must lie wrong.
TriangleMesh mesh_of(const FoldFrame& frame, double thickness);

}  // namespace hada
