#pragma once

#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"

namespace hada {

/// The lights that agree best with all spheres and with the sample at once.
struct RefinedLights {
  std::vector<Light> lights;             // direction as seen from the middle of the sample
  std::vector<LightErrorMode> errors;    // how they may be wrong together
  std::vector<std::vector<Light>> seen;  // for each sphere: what it alone says, at its own place
  double disagreement = 0.0;             // mean angle between what two spheres say, radians
  bool near = false;                     // whether the lamps have a position
  bool strengths_measured = true;        // false: neither a matte sphere nor a sample shows them
  double sheet_ambient = 0.0;            // left on the sample, in grey
  bool sample_believed = true;           // false: it speaks against all spheres, and was not asked
};

/// One least-squares problem over directions, strengths and, for near lamps, distances; over place
/// and radius of every sphere, held by its outline; over the reflectance of matte spheres for light
/// that the sample throws at them; and over albedo and normal of some pixels of the sample.
///
/// Lamps are taken to be near where the evidence puts them nearer than a hundred times half the
/// picture's diagonal, all together; or as the owner of the pictures says (`CaptureFile::lamps`).
///
/// Where a mirror and a matte sphere contradict each other by more than a degree and 1.5 standard
/// deviations of the mirror, its highlights outweigh all shading: they hang on its outline alone.
/// A sample under which most lights would lie more than 2.5 standard deviations from where the
/// spheres see them is no sample that could tell: then the spheres are asked alone.
///
/// linear    the photographs, with linear values
/// readings  each sphere by itself
/// lights    the readings combined: where the descent starts; strengths in grey
/// colours   of each light, as `evidence` takes them; part of the strengths that are returned
/// ambient   what was taken off all pictures, in grey: the sample may have shown half as much
///           again, or half of it, for it is not as white as the sphere
RefinedLights refined_lights(const Photographs& linear, const std::vector<SphereReading>& readings,
                             const std::vector<Light>& lights,
                             const std::vector<Eigen::Vector3d>& colours, double ambient = 0.0);

}  // namespace hada
