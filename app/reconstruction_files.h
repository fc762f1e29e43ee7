#pragma once

#include <string>

#include "app/lit_capture.h"
#include "io/output.h"
#include "reconstruct/reconstruct.h"

namespace hada {

/// What a surface folder remembers of its making, as a JSON object: estimator, noise, errors of
/// relighting, condition of the lights, how many samples carry each label, and all that was
/// remarked on the capture and on the surface.
std::string surface_notes(const Reconstruction& reconstruction, const LitCapture& lit);

/// Puts a surface that was reconstructed into `folder` of the output ("" or "surface/"): its maps
/// and previews, lights.json, albedo_sigma.exr, inliers.png (a count in every pixel) and, where
/// they were asked for, labels/01.png and so on, a picture of the labels for each light.
void put_reconstruction(Output& output, const std::string& folder,
                        const Reconstruction& reconstruction, const LitCapture& lit);

/// "samples: 97.1 % lit, 2.0 % in attached shadow, ..."; empty where no labels were asked for
std::string told_of_labels(const Reconstruction& reconstruction);

}  // namespace hada
