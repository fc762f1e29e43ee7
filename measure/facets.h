#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/grid.h"
#include "core/surface.h"

namespace hada {

/// A part of a surface that is a plane: z = slope . (x, y) + const.
struct Facet {
  Eigen::Vector2d slope{0.0, 0.0};  // dz/dx, dz/dy
  double sigma = 0.0;               // of each slope, from how its parts differ
  int pixels = 0;                   // that were averaged
};

/// The flat parts of a creased sheet.
struct Facets {
  std::vector<Facet> facets;
  Grid<int> label;  // of every pixel of the mask: the facet that it belongs to or is nearest to; -1
                    // outside
  int reach_px = 0;  // how far from a crease slopes were not believed
};

struct FacetOptions {
  double smallest_fold_deg = 1.0;  // facets that differ by less are one
};

/// Planes are where slopes, averaged over a window that drowns the noise, stay the same from one
/// side of the window to the other; connected pixels of that kind are a facet.
///
/// throws  Error if the surface has no normals or no flat part
Facets facets_of(const Surface& surface, const FacetOptions& options = {});

}  // namespace hada
