#include "capture/virtual_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int sphere_split = 4;  // sub-cells along a side of a cell that a sphere touches

bool is_coloured(const Light& light) {
  return light.strength != Vector3d::Constant(light.strength.x());
}

double albedo_of(const Image& albedo, int channel, int row, int col) {
  if (albedo.empty()) return 1.0;
  return albedo.planes[std::size_t(albedo.channels() == 3 ? channel : 0)](row, col);
}

Vector3d mean_albedo(const Surface& sheet) {
  Vector3d sum = Vector3d::Zero();
  double count = 0.0;
  for (int row = 0; row < sheet.extent.rows; ++row) {
    for (int col = 0; col < sheet.extent.cols; ++col) {
      if (!sheet.mask(row, col)) continue;
      for (int c = 0; c < 3; ++c) sum[c] += albedo_of(sheet.albedo, c, row, col);
      count += 1.0;
    }
  }
  return sum / std::max(count, 1.0);
}

}  // namespace

// A point that is seen, and how it reflects.
struct VirtualScene::Spot {
  Vector3d point;
  Vector3d normal;
  Vector3d albedo;
  int sphere = -1;  // the index of the sphere it lies on
};

SheetPlace place_of(const Surface& sheet, const Rig& rig) {
  if (!sheet.has_height() || sheet.extent.unit != Unit::mm) {
    throw Error("virtual camera: the sheet has no height in mm; give its pitch in mm");
  }
  const int oversampling = int(std::lround(rig.pitch_mm / sheet.extent.pitch));
  if (oversampling < 1 ||
      std::abs(oversampling * sheet.extent.pitch - rig.pitch_mm) > 1e-6 * rig.pitch_mm) {
    throw Error("virtual camera: the pitch of the picture, " + std::to_string(rig.pitch_mm) +
                " mm, is not a whole multiple of that of the sheet, " +
                std::to_string(sheet.extent.pitch) + " mm; choose one that is");
  }
  const int rows = rig.rows * oversampling;
  const int cols = rig.cols * oversampling;
  const double pitch = sheet.extent.pitch;
  const int row = int(std::lround(0.5 * (rows - sheet.extent.rows) - rig.sheet_place.y() / pitch));
  const int col = int(std::lround(0.5 * (cols - sheet.extent.cols) + rig.sheet_place.x() / pitch));
  if (row < 0 || col < 0 || row + sheet.extent.rows > rows || col + sheet.extent.cols > cols) {
    throw Error(
        "virtual camera: the sheet does not fit into the picture; enlarge the picture or "
        "move the sheet");
  }
  return {oversampling, row, col};
}

VirtualScene::VirtualScene(const Surface& sheet, const Rig& rig)
    : sheet_(sheet), rig_(rig), place_(place_of(sheet, rig)), mean_albedo_(mean_albedo(sheet)) {
  fine_ = {rig.rows * oversampling(), rig.cols * oversampling(), sheet.extent.pitch, Unit::mm};
  normals_ = sheet.normals.empty() ? normals_of(sheet.height, sheet.mask, sheet.extent.pitch)
                                   : sheet.normals;
  unit_lights_ = rig.lights;
  for (Light& light : unit_lights_) light.strength = Vector3d::Ones();
  const bool coloured = std::any_of(rig.lights.begin(), rig.lights.end(), is_coloured);
  channels_ = coloured || sheet.albedo.channels() == 3 ? 3 : 1;

  float lowest = HUGE_VALF;
  for (std::size_t i = 0; i < sheet.height.size(); ++i) {
    if (sheet.mask[i]) lowest = std::min(lowest, sheet.height[i]);
  }
  Grid<float> height(fine_.rows, fine_.cols);
  on_sheet_ = Mask(fine_.rows, fine_.cols);
  for (int row = 0; row < sheet.extent.rows; ++row) {
    for (int col = 0; col < sheet.extent.cols; ++col) {
      if (!sheet.mask(row, col)) continue;
      height(place_.row + row, place_.col + col) = sheet.height(row, col) - lowest;
      on_sheet_(place_.row + row, place_.col + col) = 1;
    }
  }
  relief_ = Relief(std::move(height), fine_.pitch);
}

Vector3d VirtualScene::cell(int row, int col) const {
  const Vector2d place = fine_.place(row, col);
  return {place.x(), place.y(), relief_.height()(row, col)};
}

bool VirtualScene::near_sphere(int row, int col) const {
  const Vector2d place = fine_.place(row, col);
  return std::any_of(rig_.spheres.begin(), rig_.spheres.end(), [&](const TableSphere& sphere) {
    return (place - sphere.place).norm() < 0.5 * sphere.diameter_mm + fine_.pitch;
  });
}

VirtualScene::Spot VirtualScene::ground(int row, int col) const {
  if (!on_sheet_(row, col)) {
    return {cell(row, col), Vector3d::UnitZ(), Vector3d::Constant(rig_.table_albedo)};
  }
  const int sheet_row = row - place_.row;
  const int sheet_col = col - place_.col;
  Spot spot{cell(row, col), normals_(sheet_row, sheet_col).cast<double>(), Vector3d::Zero()};
  for (int c = 0; c < channels_; ++c) {
    spot.albedo[c] = albedo_of(sheet_.albedo, c, sheet_row, sheet_col);
  }
  return spot;
}

bool VirtualScene::hidden_by_spheres(const Spot& spot, const Vector3d& to_light) const {
  for (std::size_t i = 0; i < rig_.spheres.size(); ++i) {
    if (int(i) == spot.sphere) continue;
    const TableSphere& sphere = rig_.spheres[i];
    const double radius = 0.5 * sphere.diameter_mm;
    const Vector3d way = Vector3d(sphere.place.x(), sphere.place.y(), radius) - spot.point;
    const double along = way.dot(to_light);
    if (along > 0.0 && way.squaredNorm() - along * along < radius * radius) return true;
  }
  return false;
}

// Of unit strength: the cosine, the fall-off of a near light, 0 in the shadow.
double VirtualScene::irradiance(const Spot& spot, const Light& light) const {
  const Vector3d arrival = arriving(light, 0, spot.point);
  const double received = spot.normal.dot(arrival);
  if (received <= 0.0 || !rig_.cast_shadows) return std::max(received, 0.0);
  const Vector3d to_light = light.position ? Vector3d(arrival.normalized()) : arrival;
  const bool hidden = hidden_by_spheres(spot, to_light) ||
                      relief_.hides(fine_.pixel(spot.point.head<2>()), spot.point.z(), to_light);
  return hidden ? 0.0 : received;
}

void VirtualScene::add_matte(const Spot& spot, double weight, std::span<double> sums) const {
  for (std::size_t i = 0; i < unit_lights_.size(); ++i) {
    const double received = rig_.exposure * irradiance(spot, unit_lights_[i]);
    for (int c = 0; c < channels_; ++c) {
      sums[i * std::size_t(channels_) + std::size_t(c)] +=
          weight * spot.albedo[c] * (received * rig_.lights[i].strength[c] + rig_.ambient);
    }
  }
}

void VirtualScene::add_chrome(const Spot& spot, double weight, std::span<double> sums) const {
  const Vector3d mirrored = 2.0 * spot.normal.z() * spot.normal - Vector3d::UnitZ();
  if (mirrored.z() < 0.0) {
    const Vector3d on_table = spot.point - spot.point.z() / mirrored.z() * mirrored;
    const Vector2d pixel = fine_.pixel(on_table.head<2>());
    const int row = int(std::floor(pixel.x() + 0.5));
    const int col = int(std::floor(pixel.y() + 0.5));
    const bool sheet = on_sheet_.contains(row, col) && on_sheet_(row, col);
    const double z = sheet ? relief_.height()(row, col) : 0.0;
    const double table = rig_.table_albedo;
    const Spot seen{{on_table.x(), on_table.y(), z},
                    Vector3d::UnitZ(),
                    sheet ? mean_albedo_ : Vector3d::Constant(table)};
    add_matte(seen, weight * spot.albedo.x(), sums);
  }
  // A light that is a disc of this half angle and as bright as its irradiance asks for: a white
  // sheet facing it is sin^2 as bright as the disc itself.
  const double half_angle = 0.5 * rig_.light_diameter;
  const double brightness = rig_.exposure / std::pow(std::sin(half_angle), 2);
  for (std::size_t i = 0; i < unit_lights_.size(); ++i) {
    const Vector3d arrival = arriving(unit_lights_[i], 0, spot.point);
    const double falloff = arrival.norm();
    if (mirrored.dot(arrival) < falloff * std::cos(half_angle)) continue;
    if (rig_.cast_shadows && hidden_by_spheres(spot, arrival / falloff)) continue;
    for (int c = 0; c < channels_; ++c) {
      sums[i * std::size_t(channels_) + std::size_t(c)] +=
          weight * spot.albedo.x() * brightness * falloff * rig_.lights[i].strength[c];
    }
  }
}

void VirtualScene::add_sphere_cell(int row, int col, std::span<double> sums) const {
  constexpr double weight = 1.0 / (sphere_split * sphere_split);
  int uncovered = 0;
  for (int part = 0; part < sphere_split * sphere_split; ++part) {
    const Vector2d place = fine_.place(row - 0.5 + (part / sphere_split + 0.5) / sphere_split,
                                       col - 0.5 + (part % sphere_split + 0.5) / sphere_split);
    Spot top{Vector3d(0.0, 0.0, -1.0), {}, {}};
    for (std::size_t i = 0; i < rig_.spheres.size(); ++i) {
      const TableSphere& sphere = rig_.spheres[i];
      const double radius = 0.5 * sphere.diameter_mm;
      const Vector2d offset = place - sphere.place;
      const double depth = radius * radius - offset.squaredNorm();
      if (depth <= 0.0 || radius + std::sqrt(depth) <= top.point.z()) continue;
      const Vector3d from_centre(offset.x(), offset.y(), std::sqrt(depth));
      top = {{place.x(), place.y(), radius + from_centre.z()},
             from_centre / radius,
             Vector3d::Constant(sphere.albedo),
             int(i)};
    }
    if (top.sphere < 0) {
      ++uncovered;
    } else if (rig_.spheres[std::size_t(top.sphere)].kind == SphereKind::chrome) {
      add_chrome(top, weight, sums);
    } else {
      add_matte(top, weight, sums);
    }
  }
  if (uncovered > 0) add_matte(ground(row, col), weight * uncovered, sums);
}

void VirtualScene::add_cell(int row, int col, std::span<double> sums) const {
  if (near_sphere(row, col)) {
    add_sphere_cell(row, col, sums);
  } else {
    add_matte(ground(row, col), 1.0, sums);
  }
}

}  // namespace hada
