#pragma once

#include "core/grid.h"
#include "core/surface.h"
#include "reconstruct/level.h"
#include "reconstruct/prior_heights.h"

namespace hada {

/// The standard deviation of the height that `integrate` finds, from that of the normals.
///
/// Independent errors of the normals are drawn, integrated and levelled as the height is, and the
/// spread at each pixel (smoothed over its neighbourhood) is returned.
///
/// Long waves make most of the spread, and it takes many draws to know theirs: 512, on a lattice of
/// cells of 4 x 4 pixels. What that lattice leaves out is the mean difference in 32 draws that both
/// share (multilevel Monte Carlo: M. B. Giles, Operations Research 56 (2008)). A mask above a
/// quarter of a million pixels is drawn on a coarser lattice, and each octave of detail left out
/// adds its share, v pitch^2 ln 2 / (2 pi) for slopes of variance v.
///
/// An error that all pixels share (a light that is off) bends the whole sheet and is not in here.
///
/// prior         instead of levelling, where it is not null; its own heights are taken for exact
/// weight        of each pixel, as `integrate` was given it, or null: all count alike
/// normal_sigma  radians along each tangent axis
/// returns       in the unit of `pitch`; 0 outside the mask
Grid<float> height_sigma(const NormalMap& normals, const Grid<float>& normal_sigma,
                         const Mask& mask, double pitch, Levelling levelling,
                         const PriorHeights* prior = nullptr, const Grid<float>* weight = nullptr);

}  // namespace hada
