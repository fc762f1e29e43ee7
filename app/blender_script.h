#pragma once

#include <string>

#include "core/extent.h"
#include "synth/wood_graph.h"

namespace hada {

/// A Python script for Blender 3.4 that makes the stem of `graph` a material of native nodes, and
/// the cut of `wood` a mesh that wears it; `-- --render FILE` draws the cut. Its pictures are
/// looked for beside it, as NAME.exr.
///
/// One unit of Blender is one mm. Whatever wears the material is carved out of the stem: the
/// coordinates of the object are those of `Wood`.
std::string blender_script(const WoodGraph& graph, const Wood<>& wood, const Extent& extent);

}  // namespace hada
