#pragma once

#include <vector>

#include "core/grid.h"
#include "core/light_stack.h"
#include "core/surface.h"

namespace hada {

/// The light that the rest of the surface throws on each pixel, for each picture.
struct Bounce {
  int step = 1;  // of the lattice below, in pixels
  std::vector<Grid<float>>
      gathered;     // for each light: sum over what a pixel sees of form factor * I
  Grid<float> rho;  // the albedo, in the unit of the pictures; 0 off the surface

  /// `gathered` of light k at a pixel, between the points of the lattice.
  float at(int light, int row, int col) const;
};

/// Gathers the bounce off the pictures themselves.
///
/// A matte surface sends as much light sideways as to the camera, so what a pixel receives from its
/// neighbours is their brightness in the same picture times the form factor, which the shape alone
/// gives: no light is traced. Around each point of a lattice of about 60000 points the horizon is
/// followed along 12 directions; each time it rises, what rises is seen, and adds
/// 1/pi * integral of (n.w) cos(elevation) over the new elevations.
///
/// Channels are averaged, as `adaptive` does.
///
/// height  in extent.unit, of the size of the pictures
/// rho     the albedo found so far, in the unit of the pictures; 0 where nothing is known
///
/// Sources: S. K. Nayar, K. Ikeuchi, T. Kanade, Shape from interreflections, IJCV 6 (1991), for the
/// idea to take interreflection off and solve again; L. Bavoil, M. Sainz, R. Dimitrov, Image-space
/// horizon-based ambient occlusion, SIGGRAPH talks (2008), for following the horizon.
Bounce gather_bounce(const LightStack& stack, const Grid<float>& height, const NormalMap& normals,
                     Grid<float> rho);

}  // namespace hada
