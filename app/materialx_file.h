#pragma once

#include <string>

#include "synth/wood_graph.h"

namespace hada {

/// A MaterialX 1.38 document with two materials: "wood", a graph of standard nodes that carves any
/// mesh out of the stem (its object space is that of `Wood`, mm), and "cut", which lays the colour
/// map of hada's own cut over the texture coordinates of a mesh.
///
/// Its pictures are looked for beside it: NAME.exr of the graph, and `cut_map`.
std::string materialx_document(const WoodGraph& graph, const std::string& cut_map);

}  // namespace hada
