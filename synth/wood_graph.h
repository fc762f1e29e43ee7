#pragma once

#include <map>
#include <string>

#include "core/extent.h"
#include "core/image.h"
#include "core/random.h"
#include "synth/node_graph.h"
#include "synth/wood.h"

namespace hada {

/// A stem as nodes of a shader: they follow the fibre of a place down to z = 0 and look there at a
/// picture of the section (Kawai, equation 3 and section 5).
struct WoodGraph {
  NodeGraph nodes;  // of a place in the frame of `Wood`, mm; the last is the colour
  /// By name. "section": effective radius to the right, the turn around the pith from the top down.
  /// "lean", where fibres fluctuate or interlock: the arc of a fibre in mm, effective radius to the
  /// right, z from the highest at the top down.
  std::map<std::string, Image> pictures;
  bool complete = true;  // without: wobble and figure, which no picture of two coordinates holds
};

/// extent  of the cut of `wood`; how far the pictures reach, and how finely, follows from it
/// seed    as of `surface_of`
/// throws  what `cut_of` does
WoodGraph wood_graph(const Wood<>& wood, const Extent& extent, Seed seed);

}  // namespace hada
