#include "bench/light_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "capture/calibrate.h"
#include "capture/photograph.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double pitch_mm = 0.2;
constexpr int finer = 4;

Surface waved_sheet(double side_mm, Seed seed) {
  Surface sheet;
  const int side = int(std::lround(side_mm * finer / pitch_mm));
  sheet.extent = {side, side, pitch_mm / finer, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = Grid<float>(side, side);
  sheet.albedo = Image(Grid<float>(side, side, 0.8f));
  const double turn = 2.0 * std::numbers::pi * uniform(seed, 1);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const Eigen::Vector2d place = sheet.extent.place(row, col);
      sheet.height(row, col) = float(0.5 * std::sin(0.5 * place.x() + turn) +
                                     0.4 * std::cos(0.4 * place.y() + 0.3 * place.x()));
    }
  }
  return sheet;
}

std::vector<Light> drawn_lights(bool near, Seed seed) {
  constexpr int count = 8;
  std::vector<Light> lights(count);
  for (int k = 0; k < count; ++k) {
    Light& light = lights[std::size_t(k)];
    const double slant = (25.0 + 25.0 * uniform(seed, 10, k)) * degree;
    const double azimuth = 2.0 * std::numbers::pi * (k + 0.7 * uniform(seed, 11, k)) / count;
    light.direction = {std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                       std::cos(slant)};
    light.strength.setConstant(0.85 + 0.3 * uniform(seed, 12, k));
    if (near) light.position = (250.0 + 150.0 * uniform(seed, 13, k)) * light.direction;
  }
  return lights;
}

Photographs photographs_of(const LightStack& stack) {
  Photographs photographs;
  photographs.camera = stack.camera;
  photographs.images = stack.images;
  photographs.bits = 16;
  photographs.file.folder = "virtual";
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    const std::string name = "picture_" + std::to_string(k);
    photographs.file.pictures.push_back({name, name, {}, {}});
    Mask saturated(stack.extent().rows, stack.extent().cols, 0);
    for (std::size_t i = 0; i < saturated.size(); ++i) {
      saturated[i] = stack.samples[k][i] == Sample::saturated;
    }
    photographs.saturated.push_back(std::move(saturated));
  }
  return photographs;
}

}  // namespace

LightStudy study_lights(const LightStudyOptions& options) {
  std::vector<double> errors, places;
  double within = 0.0;
  double squares = 0.0;
  LightStudy study;
  for (int i = 0; i < options.seeds; ++i) {
    const Seed seed = Seed(1000 + i);
    Rig rig;
    rig.rows = 260;
    rig.cols = 400;
    rig.pitch_mm = pitch_mm;
    rig.sheet_place = {14.0, 0.0};
    rig.lights = drawn_lights(options.near, seed);
    rig.spheres = {{.kind = options.chrome ? SphereKind::chrome : SphereKind::matte,
                    .place = {-26.0, 10.0 * uniform(seed, 3) - 5.0},
                    .diameter_mm = 16.0,
                    .albedo = options.chrome ? 0.9 : 0.6}};
    rig.seed = seed;
    const Surface sheet = waved_sheet(44.0, seed);
    const LightStack stack = photograph(sheet, rig);
    const Calibration found = calibrate(photographs_of(stack));
    // The lowest point of the sheet rests on the table; found places count from its mean height.
    const double height = -*std::min_element(sheet.height.begin(), sheet.height.end());
    const Eigen::Vector3d middle(14.0, 0.0, height);
    for (std::size_t k = 0; k < stack.lights.size(); ++k) {
      const Light& light = found.lights[k];
      const Eigen::Vector3d truth =
          options.near ? (*rig.lights[k].position - middle).normalized() : rig.lights[k].direction;
      // The mask's middle may lie a pixel off: both directions are taken from the true one.
      const Eigen::Vector3d direction =
          options.near && light.position
              ? Eigen::Vector3d(*light.position - Eigen::Vector3d(14.0, 0.0, 0.0)).normalized()
              : light.direction;
      const Eigen::Vector3d first = truth.unitOrthogonal();
      for (const Eigen::Vector3d& axis : {first, Eigen::Vector3d(truth.cross(first))}) {
        const double z = direction.dot(axis) / light.direction_sigma;
        within += std::abs(z) < 1.645;
        squares += z * z;
        ++study.components;
      }
      errors.push_back(std::acos(std::min(1.0, truth.dot(direction))) / degree);
      if (options.near && light.position) {
        places.push_back(
            (*light.position + Eigen::Vector3d(0.0, 0.0, height) - *rig.lights[k].position).norm());
      }
    }
  }
  study.median_error_deg = median(std::move(errors));
  study.coverage90 = within / study.components;
  study.typical_z = std::sqrt(squares / study.components);
  if (!places.empty()) study.position_mm = median(std::move(places));
  return study;
}

}  // namespace hada
