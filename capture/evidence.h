#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "capture/calibrate.h"
#include "capture/load.h"
#include "core/camera.h"

namespace hada {

/// What the pictures show on one matte sphere: values of some of its pixels, picture by picture.
struct MatteEvidence {
  std::size_t sphere = 0;                   // whose reading it is
  std::vector<Ray> rays;                    // to the middle of a square of pixels each
  std::vector<Eigen::Vector3d> bends;       // mean normal of the square less that in its middle
  std::vector<Eigen::Vector2d> places;      // of each on the disc, -1 to 1
  std::vector<std::vector<double>> values;  // [picture][pixel]; NaN: not to be believed
  std::vector<std::vector<double>> thrown;  // what the surroundings add if the sphere were white
};

/// Where one light is mirrored in a chrome sphere.
struct ChromeEvidence {
  std::size_t sphere = 0;
  std::size_t light = 0;
  Ray ray;                 // to the middle of the highlight
  Eigen::Vector3d offset;  // from the ray mirrored there to the middle of the mirrored lamp
  double sigma = 0.0;      // of the mirrored direction, the outline apart, radians
};

/// Values of some pixels of the sample, which is taken to be matte and to lie close to z = 0.
struct SheetEvidence {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<double>> values;  // [pixel][picture]; NaN: not to be believed
  Eigen::Vector3d center{0.0, 0.0, 0.0};    // of the sample
};

/// All that the pictures say about the lights, thinned to what a joint fit can use.
struct Evidence {
  std::vector<MatteEvidence> matte;
  std::vector<ChromeEvidence> chrome;
  SheetEvidence sheet;
};

/// linear      the photographs, with linear values
/// readings    the spheres, each read by itself
/// colours     of each light, the strength of each channel over that in grey; divided out, so that
///             a coloured sample shows the same strengths as a grey sphere
/// ask_sample  false: the sample has its middle, but no points
/// throws      Error if there is no sample, and the matte spheres leave a light's strength open
Evidence evidence(const Photographs& linear, const std::vector<SphereReading>& readings,
                  const std::vector<Eigen::Vector3d>& colours, bool ask_sample = true);

}  // namespace hada
