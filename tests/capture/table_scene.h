#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "capture/load.h"
#include "capture/photograph.h"
#include "core/random.h"

/// A small virtual table with a sheet and spheres, for the tests of this room. The camera renders
/// four times finer than a pixel, adds noise and stores 16 bits.
namespace hada {

constexpr double degree = std::numbers::pi / 180.0;

inline Light light_at(double slant_deg, double azimuth_deg, double strength = 1.0) {
  Light light;
  const double slant = slant_deg * degree;
  const double azimuth = azimuth_deg * degree;
  light.direction = {std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                     std::cos(slant)};
  light.strength.setConstant(strength);
  return light;
}

inline std::vector<Light> six_lights() {
  return {light_at(30, 10, 1.05), light_at(45, 75, 0.95),  light_at(35, 130, 1.1),
          light_at(50, 190, 0.9), light_at(28, 250, 1.02), light_at(42, 310, 0.98)};
}

/// A gently waved sheet of `side_mm`, at 0.05 mm.
inline Surface waved_sheet(double side_mm) {
  Surface sheet;
  const int side = int(std::lround(side_mm / 0.05));
  sheet.extent = {side, side, 0.05, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = Grid<float>(side, side);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const Eigen::Vector2d place = sheet.extent.place(row, col);
      sheet.height(row, col) = float(0.4 * std::sin(0.6 * place.x()) +
                                     0.3 * std::cos(0.5 * place.y() + 0.3 * place.x()));
    }
  }
  sheet.albedo = Image(Grid<float>(side, side, 0.8f));
  return sheet;
}

/// 300 x 200 pixels of 0.2 mm: a 24 mm sheet to the right, spheres of 10 mm to the left.
inline Rig table_rig(std::vector<TableSphere> spheres) {
  Rig rig;
  rig.rows = 200;
  rig.cols = 300;
  rig.pitch_mm = 0.2;
  rig.sheet_place = {12.0, 0.0};
  rig.lights = six_lights();
  rig.spheres = std::move(spheres);
  rig.bits = 16;
  rig.seed = 7;
  return rig;
}

inline TableSphere matte_at(double x, double y, double diameter = 10.0) {
  return {.kind = SphereKind::matte, .place = {x, y}, .diameter_mm = diameter, .albedo = 0.6};
}

inline TableSphere chrome_at(double x, double y, double diameter = 10.0) {
  return {.kind = SphereKind::chrome, .place = {x, y}, .diameter_mm = diameter, .albedo = 0.9};
}

/// The pictures of a stack as if they had been loaded from files.
inline Photographs photographs_of(const LightStack& stack) {
  Photographs photographs;
  photographs.camera = stack.camera;
  photographs.images = stack.images;
  photographs.bits = 16;
  photographs.file.folder = "table";
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    CaptureFile::Picture picture;
    picture.name = "picture_" + std::to_string(k) + ".png";
    picture.file = picture.name;
    photographs.file.pictures.push_back(picture);
    Mask saturated(stack.extent().rows, stack.extent().cols, 0);
    for (std::size_t i = 0; i < saturated.size(); ++i) {
      saturated[i] = stack.samples[k][i] == Sample::saturated;
    }
    photographs.saturated.push_back(std::move(saturated));
  }
  return photographs;
}

inline Photographs table_scene(std::vector<TableSphere> spheres) {
  return photographs_of(photograph(waved_sheet(24.0), table_rig(std::move(spheres))));
}

/// Multiplies what a picture shows within `radius_px` of a place and adds `ambient`.
inline void dim_disc(Grid<float>& picture, const Eigen::Vector2d& center, double radius_px,
                     float factor, float ambient) {
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 0; col < picture.cols(); ++col) {
      if ((Eigen::Vector2d(col + 0.5, row + 0.5) - center).norm() > radius_px) continue;
      picture(row, col) = factor * picture(row, col) + ambient;
    }
  }
}

inline void put_on_disk(Photographs& photographs) {
  for (Image& image : photographs.images) {
    for (auto& plane : image.planes) {
      Grid<float> on_disk(plane.rows(), plane.cols(), 0.0f, scratch_files());
      std::copy(plane.begin(), plane.end(), on_disk.begin());
      plane = std::move(on_disk);
    }
  }
}

inline double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::min(1.0, a.normalized().dot(b.normalized()))) / degree;
}

}  // namespace hada
