#include "bench/normals_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "capture/light_stack.h"
#include "capture/load.h"
#include "core/quantile.h"
#include "core/random.h"
#include "io/image_file.h"
#include "io/json.h"
#include "reconstruct/reconstruct.h"

namespace hada {
namespace {

namespace fs = std::filesystem;
constexpr double degree = std::numbers::pi / 180.0;
// 90 % of a two-dimensional normal error of standard deviation s per axis lie within 2.146 s.
const double ninety = std::sqrt(-2.0 * std::log(0.1));

Json json_at(const fs::path& path) {
  std::ifstream in(path);
  return Json::parse(in);
}

Eigen::Vector3d next_vector(std::istream& in) {
  Eigen::Vector3d vector;
  in >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

NormalMap normals_in(const Image& image) {
  NormalMap normals(image.rows(), image.cols(), Eigen::Vector3f::UnitZ());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector3f normal(image.planes[0][i], image.planes[1][i], image.planes[2][i]);
    if (normal.allFinite() && normal.norm() > 0.5f) normals[i] = normal.normalized();
  }
  return normals;
}

CaptureFile capture_of(const fs::path& scene, const Json& inputs) {
  CaptureFile file;
  file.folder = scene;
  for (const auto& image : inputs["images"]) {
    const std::string name = image;
    file.pictures.push_back({scene / name, name, {}, {}});
  }
  file.encoding = inputs["encoding"];
  file.pitch_mm = inputs["pixel_mm"].get<double>();
  if (inputs.contains("ambient")) file.ambient = scene / inputs["ambient"].get<std::string>();
  return file;
}

std::vector<Light> lights_of(const Json& truth) {
  const Json& given = truth["lights"];
  std::vector<Light> lights;
  for (std::size_t k = 0; k < given["directions"].size(); ++k) {
    const auto vector = [&](const char* key) {
      const Json& v = given[key][k];
      return Eigen::Vector3d(v[0], v[1], v[2]);
    };
    Light light;
    light.image = fmt::format("light {}", k + 1);
    light.direction = vector("directions").normalized();
    light.strength.setConstant(given["intensities"][k].get<double>());
    if (given["model"] == "point") {
      // The stack's z = 0 is where a pixel spans the pitch: the mean height of the sheet.
      light.position = vector("positions_mm") -
                       Eigen::Vector3d(0.0, 0.0, truth["sheet"]["mean_height_mm"].get<double>());
      // The strengths are of light at 400 mm, those of a stack of light at the origin.
      light.strength *= std::pow(400.0 / light.position->norm(), 2);
    }
    lights.push_back(light);
  }
  return lights;
}

}  // namespace

NormalScene diligent_ball(const fs::path& data) {
  const fs::path folder = data / "photos" / "diligent_ball";
  std::ifstream names(folder / "filenames.txt");
  std::ifstream directions(folder / "light_directions.txt");
  std::ifstream strengths(folder / "light_intensities.txt");
  NormalScene scene{.name = "ball", .stack = {}, .truth = {}};
  LightStack& stack = scene.stack;
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
  stack.samples.assign(stack.lights.size(), Grid<Sample>(mask.rows(), mask.cols(), Sample::lit));
  scene.truth = normals_in(read_image(folder / "normal_gt.tif").image);
  return scene;
}

NormalScene rendered_scene(const fs::path& folder) {
  const Json inputs = json_at(folder / "inputs.json");
  const Json truth = json_at(folder / "truth" / "truth.json");
  Photographs photographs = load_photographs(capture_of(folder, inputs));
  const Image normals = read_image(folder / "truth" / "normals.exr").image;
  photographs.mask = Mask(normals.rows(), normals.cols());
  for (std::size_t i = 0; i < photographs.mask.size(); ++i) {
    photographs.mask[i] = std::isfinite(normals.planes[0][i]);
  }
  NormalScene scene{.name = folder.filename().string(), .stack = {}, .truth = normals_in(normals)};
  scene.stack = light_stack(std::move(photographs), lights_of(truth), {});
  return scene;
}

std::vector<std::string> normal_scenes() {
  return {"ball",        "paper_wrinkled", "paper_creased", "paper_glossy_printed",
          "cloth_rough", "near_light"};
}

NormalScene normal_scene(const fs::path& data, const std::string& name) {
  return name == "ball" ? diligent_ball(data) : rendered_scene(data / "rendered" / name);
}

NormalScore normal_score(const NormalScene& scene, Estimator estimator) {
  const auto begin = std::chrono::steady_clock::now();
  const Reconstruction found = reconstruct(scene.stack, {.estimator = estimator});
  NormalScore score;
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Surface& surface = found.surface;
  std::vector<double> errors;
  double sum = 0.0;
  double within = 0.0;
  for (int row = 0; row < surface.mask.rows(); ++row) {
    for (int col = 0; col < surface.mask.cols(); ++col) {
      if (!surface.mask(row, col)) continue;
      const Eigen::Vector3d normal = surface.normals(row, col).cast<double>();
      const Eigen::Vector3d truth =
          scene.truth(row + surface.offset_px.y(), col + surface.offset_px.x()).cast<double>();
      const double error = std::atan2(normal.cross(truth).norm(), normal.dot(truth));
      errors.push_back(error / degree);
      sum += error / degree;
      within += error < ninety * double(surface.normal_sigma(row, col));
    }
  }
  const Mask& mask = scene.stack.mask;
  const auto count = double(errors.size());
  score.mean_deg = sum / count;
  score.within_90 = within / count;
  score.solved = count / double(std::count(mask.begin(), mask.end(), 1));
  score.median_deg = median(std::move(errors));
  score.told =
      fmt::format("noise {:.4f}, relighting {:.2f} %", found.noise, 100.0 * found.relighting_error);
  for (const auto& remark : found.remarks) score.told += "; " + remark;
  return score;
}

NormalScene with_errors_of_lights(NormalScene scene, double tilt_deg, double gain, unsigned seed) {
  for (std::size_t k = 0; k < scene.stack.lights.size(); ++k) {
    Light& light = scene.stack.lights[k];
    const auto key = std::int64_t(k);
    if (light.position) light.direction = light.position->normalized();
    const Eigen::Vector3d across = light.direction.unitOrthogonal();
    const Eigen::Vector3d turned =
        light.direction + tilt_deg * degree * gaussian(seed, key, 1) * across +
        tilt_deg * degree * gaussian(seed, key, 2) * light.direction.cross(across);
    const double length = light.position ? light.position->norm() : 1.0;
    light.direction = turned.normalized();
    if (light.position) light.position = length * light.direction;
    light.strength *= 1.0 + gain * gaussian(seed, key, 3);
    light.direction_sigma = tilt_deg * degree;
  }
  return scene;
}

}  // namespace hada
