#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hada {

/// Where the real pictures are: the environment's HADA_DATA, else beside the source tree.
std::filesystem::path data_folder();

/// Two spheres of one set of real photographs against each other (uw, chrome and grey).
struct SphereAgreement {
  double mean_deg = 0.0;
  double max_deg = 0.0;
};
SphereAgreement sphere_agreement(const std::filesystem::path& data);

/// Mean angle between least-squares normals and the scanned ones on the DiLiGenT ball, with the
/// lights that its makers measured and all samples, in degrees.
double diligent_ball_error_deg(const std::filesystem::path& data);

/// Scanned normals of a DiLiGenT object integrated with its camera, jumps decided automatically.
struct DepthScore {
  double error_mm = 0.0;  // mean absolute error of the depth, after the median of the scale
  bool may_jump = false;
  std::string reason;
};
DepthScore normals_to_depth(const std::filesystem::path& data, const std::string& object);

/// A real object reconstructed under the lights of the grey sphere (uw buddha, cat, rock).
struct RelightingScore {
  double relighting_error = 0.0;  // root mean square, relative, over lit samples
  double pixels = 0.0;            // share of the owner's mask that was reconstructed
};
RelightingScore relighting(const std::filesystem::path& data, const std::string& object);

/// One rendered capture of known truth: spheres found without a box, surface by the whole path.
struct RenderedScore {
  int spheres_true = 0;
  int spheres_found = 0;  // within 5 % of a true radius of a true one, of the right kind
  int spheres_false = 0;
  double lights_deg = 0.0;  // mean over lights, seen from the middle of the sample
  double normals_deg = 0.0;
  double height_share = 0.0;  // root mean square error over the true standard deviation
};
enum class Boxes { none, given };  // rough hints of where spheres and sample are
RenderedScore rendered(const std::filesystem::path& scene, Boxes boxes = Boxes::none);

/// The shipped recipe once through the virtual camera and back.
struct LoopScore {
  double lights_deg = 0.0;
  double normals_deg = 0.0;
  double height_share = 0.0;
};
LoopScore synthetic_loop(unsigned seed);

}  // namespace hada
