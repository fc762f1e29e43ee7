#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/light_stack.h"
#include "core/surface.h"
#include "reconstruct/estimator.h"

namespace hada {

/// Pictures whose lights and normals are known, so that only the solver of normals can err.
struct NormalScene {
  std::string name;
  LightStack stack;  // with the true lights and the true mask
  NormalMap truth;
};

/// The DiLiGenT ball with the lights of its makers; every sample is called lit, as its authors do.
NormalScene diligent_ball(const std::filesystem::path& data);

/// A rendered capture with the lights, the mask and the normals of its truth.
NormalScene rendered_scene(const std::filesystem::path& scene);

/// Every scene that is there, the ball first.
std::vector<std::string> normal_scenes();
NormalScene normal_scene(const std::filesystem::path& data, const std::string& name);

struct NormalScore {
  double mean_deg = 0.0;
  double median_deg = 0.0;
  double within_90 = 0.0;  // share of pixels whose error lies within the stated 90 % interval
  double solved = 0.0;     // share of the mask
  double seconds = 0.0;
  std::string told;  // what the solver found: terms, errors, remarks
};

/// The whole of `reconstruct`, scored on its normals.
NormalScore normal_score(const NormalScene& scene, Estimator estimator);

/// Turns each light by `tilt_deg` and scales it by a factor of standard deviation `gain`, so that
/// the lights are as well known as a sphere tells them; `direction_sigma` says so.
NormalScene with_errors_of_lights(NormalScene scene, double tilt_deg, double gain, unsigned seed);

}  // namespace hada
