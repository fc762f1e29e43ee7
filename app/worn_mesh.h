#pragma once

#include "core/mesh.h"
#include "mechanics/taut_yarn.h"

namespace hada {

/// The yarns of a worn knit as tubes that lie on the body: straight from stitch to stitch, over
/// what was inserted between.
TriangleMesh yarn_mesh(const WornKnit& knit, const TautYarns& yarns, double radius_mm);

/// The middle of the yarn of a course as plain knit has it: a loop around each stitch whose head is
/// drawn through the next course, laid onto the worn stitches and lifted off the body.
///
/// Yarns pass each other at 0.076 of a wale or more, so that a radius of up to
/// `thickest_loop` wales leaves them apart.
/// returns  a closed ring of points, evenly many for each stitch
///
/// Source: the curve of `Knit`, in the sinusoidal form of Peirce, Text. Res. J. 17 (1947).
Places loop_ring(const WornKnit& knit, int course, double radius_mm);
constexpr double thickest_loop = 0.036;

/// All such rings as tubes.
TriangleMesh loop_mesh(const WornKnit& knit, double radius_mm);

}  // namespace hada
