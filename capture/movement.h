#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/grid.h"
#include "core/image.h"
#include "core/light_stack.h"
#include "core/sphere.h"

namespace hada {

/// A thing with an outline that stays where it is while the light moves.
struct Outline {
  std::string what;                     // "the sample", "the matte sphere"
  bool round = false;                   // a sphere, of which one side is dark
  std::vector<Eigen::Vector2i> pixels;  // (col, row)
  std::vector<Eigen::Vector2d> inward;  // unit, u right, v down
};

/// How far the outline lies off its place in each picture, (u, v) in px of `greys`, against the
/// median of all; not a number where the picture does not show it clearly.
///
/// The shift is the one, at most `reach` px along each axis, under which the outline collects most
/// of the gradient that points inward: things on a dark table are brighter than it from whichever
/// side they are lit. Of a round thing only the stretch that faces the light is asked; elsewhere
/// the border between light and shadow would be taken for the outline.
///
/// towards  the light of each picture as the camera sees it: (u, v) of its direction
std::vector<Eigen::Vector2d> movements(const std::vector<Grid<float>>& greys,
                                       const std::vector<Eigen::Vector2d>& towards,
                                       const Outline& outline, int reach = 24);

/// Whether camera, sample or a matte sphere moved between the pictures, in plain sentences. Shifts
/// under 1.5 px are not told; pictures of more than 1600 px are looked at in coarser steps, which
/// then count as pixels.
///
/// pictures  with linear values
/// lights    one for each picture, with its name
/// mask      of the sample; empty: its outline is not known
std::vector<std::string> remarks_on_movement(const std::vector<Image>& pictures,
                                             const std::vector<Light>& lights,
                                             const std::vector<Sphere>& spheres, const Mask& mask);

}  // namespace hada
