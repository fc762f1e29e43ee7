#pragma once

#include <vector>

#include "reconstruct/normals.h"

namespace hada {

/// What became of every sample, now that the normals are known: one grid for each picture.
///
/// A sample is compared with the prediction p of the normal and albedo that the others gave:
/// attached_shadow  where n.l <= 0, whatever its value
/// cast_shadow      where it lacks more than four sigma and a fifth of p: merely dark is not shadow
/// highlight        where it exceeds p by more than four sigma and a twentieth of the albedo
/// saturated        as the stack says; a pixel outside the mask keeps its label
///
/// found    of the same stack, with uncertainty: sigma is its noise
/// options  that it was found with
std::vector<Grid<Sample>> label_samples(const LightStack& stack, const Orientation& found,
                                        const NormalOptions& options = {});

/// How many samples of the mask carry each label, as shares of all, in the order of `Sample`.
std::vector<double> label_shares(const std::vector<Grid<Sample>>& labels, const Mask& mask);

}  // namespace hada
