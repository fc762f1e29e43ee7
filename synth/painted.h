#pragma once

#include <vector>

#include "core/surface.h"

namespace hada {

/// What a material describes that was fitted to the brightness of a picture: its field is painted
/// on a flat sheet instead of standing out of it.
///
/// drawn        as `synthesize` makes it
/// mean_albedo  linear, one value or three (red, green, blue), not black; empty: the field is a
///              height, and `drawn` is returned as it is
/// returns      no height and no normals; an albedo of as many planes and of the hue of
///              `mean_albedo`, whose brightness (`measured_map`) is that of `mean_albedo` plus the
///              field, or 0 where that is less
Surface painted(Surface drawn, const std::vector<double>& mean_albedo);

}  // namespace hada
