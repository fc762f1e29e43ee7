#include "bench/accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <vector>

#include "app/lit_capture.h"
#include "app/overlap.h"
#include "app/recipe.h"
#include "app/virtual_capture.h"
#include "capture/calibrate.h"
#include "capture/light_stack.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/normal_file.h"
#include "reconstruct/integrate.h"
#include "reconstruct/reconstruct.h"

namespace hada {
namespace {

namespace fs = std::filesystem;
constexpr double degree = std::numbers::pi / 180.0;

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) / degree;
}

// The twelve numbered pictures of one object of the uw set, with its mask.
CaptureFile uw_capture(const fs::path& data, const std::string& object) {
  return read_capture_file(data / "photos" / "uw" / object);
}

LitCapture lit(Photographs photographs) {
  return lit_capture(std::move(photographs), {}, Terminal({.quiet = true}));
}

Eigen::Vector3d next_vector(std::istream& in) {
  Eigen::Vector3d vector;
  in >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

double mean_angle_deg(const std::vector<Light>& found, const Json& truth) {
  double sum = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Eigen::Vector3d direction(truth[k][0], truth[k][1], truth[k][2]);
    sum += angle_deg(found[k].direction, direction) / double(found.size());
  }
  return sum;
}

BoxPx box_from(const Json& corners) {
  return {corners[0], corners[1], corners[2], corners[3]};
}

// What a tool may read of a rendered scene.
CaptureFile rendered_capture(const fs::path& scene, const Json& inputs, Boxes boxes) {
  CaptureFile file;
  file.folder = scene;
  for (const auto& image : inputs["images"]) {
    const std::string name = image;
    file.pictures.push_back({scene / name, name, {}, {}});
  }
  file.encoding = inputs["encoding"];
  file.pitch_mm = inputs["pixel_mm"].get<double>();
  if (inputs.contains("ambient")) file.ambient = scene / inputs["ambient"].get<std::string>();
  if (inputs.contains("camera_distance_mm")) {
    file.camera =
        CaptureFile::CameraHint{true, std::nullopt, inputs["camera_distance_mm"].get<double>()};
  }
  if (boxes == Boxes::none) return file;
  file.sample_box = box_from(inputs["sheet_box_px"]);
  for (const auto& sphere : inputs["spheres"]) {
    const SphereKind kind = sphere["kind"] == "matte" ? SphereKind::matte : SphereKind::chrome;
    file.spheres.push_back({kind, box_from(sphere["box_px"]), sphere["diameter_mm"].get<double>()});
  }
  return file;
}

Surface rendered_truth(const fs::path& scene, double pitch_mm) {
  Surface truth;
  const Image normals = read_image(scene / "truth" / "normals.exr").image;
  truth.height = luminance(read_image(scene / "truth" / "height_mm.exr").image);
  truth.extent = {truth.height.rows(), truth.height.cols(), pitch_mm, Unit::mm};
  truth.mask = Mask(truth.extent.rows, truth.extent.cols);
  truth.normals = NormalMap(truth.extent.rows, truth.extent.cols, Eigen::Vector3f::UnitZ());
  for (std::size_t i = 0; i < truth.mask.size(); ++i) {
    const Eigen::Vector3f normal(normals.planes[0][i], normals.planes[1][i], normals.planes[2][i]);
    truth.mask[i] = std::isfinite(truth.height[i]) && normal.allFinite();
    if (truth.mask[i]) truth.normals[i] = normal.normalized();
  }
  return truth;
}

void count_spheres(RenderedScore& score, const Json& truth, const Calibration& calibration) {
  score.spheres_true = int(truth["spheres"].size());
  for (const auto& reading : calibration.readings) {
    const Sphere& sphere = reading.sphere;
    const bool right =
        std::any_of(truth["spheres"].begin(), truth["spheres"].end(), [&](const Json& t) {
          const Eigen::Vector2d center(t["cx_px"], t["cy_px"]);
          const double radius = t["r_px"];
          return t["kind"] == name_of(sphere.kind) &&
                 (center - sphere.center_px).norm() < 0.05 * radius &&
                 std::abs(sphere.radius_px - radius) < 0.05 * radius;
        });
    ++(right ? score.spheres_found : score.spheres_false);
  }
}

Json json_at(const fs::path& path) {
  std::ifstream in(path);
  return Json::parse(in);
}

}  // namespace

fs::path data_folder() {
  const char* given = std::getenv("HADA_DATA");
  return given ? fs::path(given) : fs::path(HADA_SOURCE_DIR) / ".." / "shared" / "data";
}

SphereAgreement sphere_agreement(const fs::path& data) {
  const auto gray = calibrate(load_photographs(uw_capture(data, "gray")));
  const auto chrome = calibrate(load_photographs(uw_capture(data, "chrome")));
  SphereAgreement agreement;
  const std::size_t count = gray.lights.size();
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = angle_deg(gray.lights[k].direction, chrome.lights[k].direction);
    agreement.mean_deg += angle / double(count);
    agreement.max_deg = std::max(agreement.max_deg, angle);
  }
  return agreement;
}

DepthScore normals_to_depth(const fs::path& data, const std::string& object) {
  const fs::path folder = data / "normals_to_depth" / object;
  NormalFile file = read_normals(folder / "normal_map.png", false);
  const Image mask = read_image(folder / "mask.png").image;
  const Image truth = read_image(folder / "depth_mm.tif").image;
  for (std::size_t i = 0; i < file.mask.size(); ++i) {
    file.mask[i] = file.mask[i] && mask.planes[0][i] > 0.5f;
  }
  const Eigen::Matrix3d k = read_intrinsics(folder / "K.txt");
  IntegrateOptions options;
  options.pin_hole = PinHole{{k(0, 0), k(1, 1)}, {k(0, 2) + 0.5, k(1, 2) + 0.5}};
  const Integrated found =
      integrate_with_jumps(file.normals, file.mask, 1.0, Jumps::automatic, options);
  std::vector<double> scales;
  const auto depth = [&](std::size_t i) { return k(0, 0) - double(found.height[i]); };
  const auto known = [&](std::size_t i) {
    return file.mask[i] && std::isfinite(truth.planes[0][i]);
  };
  for (std::size_t i = 0; i < file.mask.size(); ++i) {
    if (known(i)) scales.push_back(truth.planes[0][i] / depth(i));
  }
  std::vector<double> sorted = scales;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < file.mask.size(); ++i) {
    if (known(i)) sum += std::abs(*middle * depth(i) - truth.planes[0][i]);
  }
  return {sum / double(scales.size()), found.may_jump, found.reason};
}

double diligent_ball_error_deg(const fs::path& data) {
  const fs::path folder = data / "photos" / "diligent_ball";
  std::ifstream names(folder / "filenames.txt");
  std::ifstream directions(folder / "light_directions.txt");
  std::ifstream strengths(folder / "light_intensities.txt");
  LightStack stack;
  for (std::string name; names >> name;) {
    stack.images.push_back(read_image(folder / name).image);
    Light light;
    light.image = name;
    light.direction = next_vector(directions).normalized();
    light.strength = next_vector(strengths);
    stack.lights.push_back(light);
  }
  const Image mask = read_image(folder / "mask.png").image;
  stack.camera.extent = {.rows = mask.rows(), .cols = mask.cols()};
  stack.mask = Mask(mask.rows(), mask.cols());
  for (std::size_t i = 0; i < stack.mask.size(); ++i) stack.mask[i] = mask.planes[0][i] > 0.5f;
  // The baseline of the benchmark is plain least squares over all samples, shadowed ones included.
  stack.samples.assign(stack.lights.size(), Grid<Sample>(mask.rows(), mask.cols(), Sample::lit));
  const Orientation found = solve_normals(stack, {.estimator = Estimator::least_squares});
  const Image truth = read_image(folder / "normal_gt.tif").image;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    if (!found.mask[i]) continue;
    const Eigen::Vector3d normal(truth.planes[0][i], truth.planes[1][i], truth.planes[2][i]);
    sum += angle_deg(found.normals[i].cast<double>(), normal);
    ++count;
  }
  return sum / count;
}

RelightingScore relighting(const fs::path& data, const std::string& object) {
  const auto gray = calibrate(load_photographs(uw_capture(data, "gray")));
  Photographs photographs = load_photographs(uw_capture(data, object));
  photographs.linear = gray.linear;
  photographs.encoding_known = true;
  const auto asked = std::count(photographs.mask.begin(), photographs.mask.end(), 1);
  const auto lights = matched_lights(gray.lights, photographs.file);
  const auto result = reconstruct(light_stack(std::move(photographs), lights, {}));
  const Mask& mask = result.surface.mask;
  const auto kept = std::count(mask.begin(), mask.end(), 1);
  return {result.relighting_error, double(kept) / double(asked)};
}

RenderedScore rendered(const fs::path& scene, Boxes boxes) {
  const Json inputs = json_at(scene / "inputs.json");
  const Json truth = json_at(scene / "truth" / "truth.json");
  const LitCapture capture = lit(load_photographs(rendered_capture(scene, inputs, boxes)));
  const Calibration& calibration = *capture.calibration;
  RenderedScore score;
  count_spheres(score, truth, calibration);
  const Json& lights = truth["lights"];
  score.lights_deg = mean_angle_deg(calibration.lights, lights["directions"]);
  const Surface surface = reconstruct(capture.stack).surface;
  if (const auto over = overlap(surface, rendered_truth(scene, surface.extent.pitch))) {
    score.normals_deg = over->normal_mean / degree;
    score.height_share = over->height_rmse / over->height_std;
  }
  return score;
}

LoopScore synthetic_loop(unsigned seed) {
  Recipe recipe =
      read_recipe(fs::path(HADA_SOURCE_DIR) / "data_synthetic" / "sheet_and_spheres.json");
  recipe.sheet_seed = seed;
  recipe.rig.seed = seed + 1000;
  const VirtualCapture capture = virtual_capture(recipe);
  const LitCapture found = lit(as_loaded(capture, recipe));
  LoopScore score;
  for (std::size_t k = 0; k < found.lights.lights.size(); ++k) {
    score.lights_deg +=
        angle_deg(found.lights.lights[k].direction, capture.stack.lights[k].direction) /
        double(found.lights.lights.size());
  }
  const Surface surface = reconstruct(found.stack).surface;
  if (const auto over = overlap(surface, capture.truth)) {
    score.normals_deg = over->normal_mean / degree;
    score.height_share = over->height_rmse / over->height_std;
  }
  return score;
}

}  // namespace hada
