#pragma once

#include <string>
#include <vector>

#include "core/image.h"
#include "mechanics/taut_yarn.h"

namespace hada {

/// From where a worn knit is seen, along level rays, and what is shown of it.
struct WornView {
  double turn_deg = 0.0;  // about the axis of the tube
  int rows = 720;
  double height_mm = 0.0;  // that the picture shows; 0: the whole knit and a little more
  double middle_mm = 0.0;  // the height along the axis in the middle of it, if height_mm is given
  int axis = 1;
  double yarn_radius_mm = 0.1;
};

/// A worn knit in sRGB: skin through the gaps of yarns.
///
/// Where stitches are larger than pixels each ray meets cylinders around the taut yarns; their
/// light is that of fibres (diffuse over the angle to the yarn, a lobe around the mirror cone),
/// their height and normal those of the circle. Where stitches are smaller the yarn is a veil that
/// lets `see_through` pass, so that it closes towards the outline.
///
/// Source: Sakaguchi and Miyata (2013), section 7; Kajiya and Kay, SIGGRAPH 1989, for fibres.
Image worn_picture(const Body& body, const WornKnit& knit, const TautYarns& yarns,
                   const WornView& view);

/// One number for each point, in the sequential palette over shaded skin, with a scale bar and a
/// colour bar from the least to the largest value.
Image worn_map(const Body& body, const WornKnit& knit, const std::vector<double>& values,
               const std::string& unit, const WornView& view);

}  // namespace hada
