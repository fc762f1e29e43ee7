#pragma once

#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"
#include "core/sphere.h"

namespace hada {

/// How one picture shades a matte sphere: I = max(0, n . b) + ambient.
struct MatteShading {
  Eigen::Vector3d b{0.0, 0.0, 0.0};  // albedo times strength times direction, of the grey value
  double ambient = 0.0;
  double misfit = 1.0;  // root mean square residual over the standard deviation of the values
  double spread = 0.0;  // standard deviation of the values over their mean
};

/// A misfit above this is not shading: half of the variance is unexplained.
constexpr double hopeless_misfit = 0.7;

/// The shading of a grey picture on the pixels of a sphere, robust against texture and dust.
///
/// Reweighted least squares (Tukey) on the lit side, then Gauss-Newton on the clipped cosine over
/// the whole disc up to `rim` of its radius. Pixels with `saturated` set are left out. A disc that
/// is even, within a millionth of its brightness, is not shaded: all of a default MatteShading.
MatteShading matte_shading(const Grid<float>& grey, const Mask& saturated, const Camera& camera,
                           const Sphere& sphere, double rim = 0.95);

/// Moves centre and radius until the shaded disc, drawn with partly covered pixels along its rim,
/// agrees with all pictures at once. linear photographs; at most `reach` px away.
Sphere sharpened_matte(const Photographs& linear, const Sphere& sphere, double reach = 2.0);

/// Every light as a matte sphere shows it. Strengths are per channel, of b; sigma by leaving out
/// one sixteenth of the disc at a time, so that residuals that hang together are not taken for
/// noise.
SphereReading read_matte_sphere(const Photographs& linear, const Sphere& sphere);

}  // namespace hada
