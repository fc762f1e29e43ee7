#pragma once

#include "core/surface.h"
#include "fit/fit.h"
#include "synth/knit.h"

namespace hada {

/// The remark that every fit of one picture makes.
inline constexpr const char* knit_at_rest_remark =
    "A picture at rest shows neither stiffness_ratio nor yarn_coefficient; they are the paper's "
    "defaults, with a sigma of 0.";

struct KnitFitOptions {
  int courses = 0;  // of the colour repeat; 0: the data decide
};

/// The plain knit that a picture shows: spacings, rotation, skew, gradients, yarn and colours.
///
/// The lattice of the spectrum starts a fit of harmonics to all pixels; the picture is then folded
/// onto one repeat, which the loop model explains for every number of courses that may lie in it.
/// Courses are taken to run within 45 degrees of the x axis, heads of loops up. What a resting
/// picture cannot show (stiffness ratio, yarn coefficient) keeps its default, with a sigma of 0.
///
/// surface  its albedo; its height where the albedo is missing or even
/// throws   Error if no lattice stands out of the spectrum
///
/// Source: Sakaguchi and Miyata (2013) for the model; the fit is ours (docs/knit.md).
Fit<Knit<>> fit_knit(const Surface& surface, const KnitFitOptions& options = {});

}  // namespace hada
