#include "capture/photograph.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "capture/virtual_scene.h"
#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

// What the sensor makes of `value`: read and shot noise, then clipped and quantised to its bits.
double sensed(double value, const Rig& rig, double deviate) {
  const double variance =
      rig.read_noise * rig.read_noise + rig.shot_noise * rig.shot_noise * std::max(value, 0.0);
  const double noisy = value + std::sqrt(variance) * deviate;
  if (rig.bits == 32) return noisy;
  const double largest = std::exp2(rig.bits) - 1.0;
  return std::round(std::clamp(noisy, 0.0, 1.0) * largest) / largest;
}

// The picture pixels that lie wholly on the sheet's lattice: a rectangle.
struct Window {
  int row, col, rows, cols;
};

Window window_of(const Surface& sheet, const SheetPlace& place) {
  const int k = place.oversampling;
  const int row = (place.row + k - 1) / k;
  const int col = (place.col + k - 1) / k;
  return {row, col, std::max((place.row + sheet.extent.rows) / k - row, 0),
          std::max((place.col + sheet.extent.cols) / k - col, 0)};
}

void take_mean_height_off(Grid<float>& height, const Mask& mask) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (!mask[i]) continue;
    sum += height[i];
    count += 1.0;
  }
  for (std::size_t i = 0; i < height.size(); ++i) {
    height[i] = mask[i] ? float(height[i] - sum / count) : 0.0f;
  }
}

}  // namespace

LightStack photograph(const Surface& sheet, const Rig& rig) {
  if (rig.bits != 8 && rig.bits != 16 && rig.bits != 32) {
    throw Error("virtual camera: " + std::to_string(rig.bits) + " bits; choose 8, 16 or 32");
  }
  const VirtualScene scene(sheet, rig);
  const int channels = scene.channels();
  const int k = scene.oversampling();
  const std::size_t pictures = rig.lights.size();

  LightStack stack;
  stack.camera.extent = {rig.rows, rig.cols, rig.pitch_mm, Unit::mm};
  stack.lights = rig.lights;
  const std::size_t values = std::size_t(rig.rows) * std::size_t(rig.cols) * std::size_t(channels);
  std::pmr::memory_resource* const memory = memory_for_pictures(pictures * values * sizeof(float));
  stack.images.assign(pictures, Image(rig.rows, rig.cols, channels, memory));
  stack.samples.assign(pictures, Grid<Sample>(rig.rows, rig.cols, Sample::lit, memory));
  stack.mask = Mask(rig.rows, rig.cols);

  const auto take_pixel = [&](int row, int col) {
    std::vector<double> sums(pictures * std::size_t(channels));
    bool sheet_only = true;
    for (int i = row * k; i < (row + 1) * k; ++i) {
      for (int j = col * k; j < (col + 1) * k; ++j) {
        scene.add_cell(i, j, sums);
        sheet_only = sheet_only && scene.shows_sheet(i, j);
      }
    }
    stack.mask(row, col) = sheet_only;
    for (std::size_t p = 0; p < pictures; ++p) {
      for (int c = 0; c < channels; ++c) {
        const double mean = sums[p * std::size_t(channels) + std::size_t(c)] / (k * k);
        const double deviate = gaussian(rig.seed, std::int64_t(p), row * rig.cols + col, c);
        const double value = sensed(mean, rig, deviate);
        stack.images[p].planes[std::size_t(c)](row, col) = float(value);
        if (rig.bits < 32 && value >= 1.0) stack.samples[p](row, col) = Sample::saturated;
      }
    }
  };
  for_each_index(rig.rows, [&](int row) {
    for (int col = 0; col < rig.cols; ++col) take_pixel(row, col);
  });
  return stack;
}

Surface seen(const Surface& sheet, const Rig& rig) {
  const SheetPlace place = place_of(sheet, rig);
  const Window window = window_of(sheet, place);
  const int k = place.oversampling;
  const NormalMap fine_normals = sheet.normals.empty()
                                     ? normals_of(sheet.height, sheet.mask, sheet.extent.pitch)
                                     : sheet.normals;

  Surface surface;
  surface.extent = {window.rows, window.cols, rig.pitch_mm, Unit::mm};
  surface.offset_px = {window.col, window.row};
  surface.mask = Mask(window.rows, window.cols);
  surface.height = Grid<float>(window.rows, window.cols);
  surface.normals = NormalMap(window.rows, window.cols, Eigen::Vector3f::UnitZ());
  surface.albedo = Image(window.rows, window.cols, sheet.albedo.channels());
  for_each_index(window.rows, [&](int row) {
    for (int col = 0; col < window.cols; ++col) {
      const int first_row = (window.row + row) * k - place.row;
      const int first_col = (window.col + col) * k - place.col;
      bool whole = true;
      double height = 0.0;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      Eigen::Vector3d albedo = Eigen::Vector3d::Zero();
      for (int i = first_row; i < first_row + k; ++i) {
        for (int j = first_col; j < first_col + k; ++j) {
          whole = whole && sheet.mask(i, j);
          height += sheet.height(i, j);
          normal += fine_normals(i, j).cast<double>();
          for (int c = 0; c < sheet.albedo.channels(); ++c) {
            albedo[c] += sheet.albedo.planes[std::size_t(c)](i, j);
          }
        }
      }
      if (!whole) continue;
      surface.mask(row, col) = 1;
      surface.height(row, col) = float(height / (k * k));
      surface.normals(row, col) = normal.normalized().cast<float>();
      for (int c = 0; c < sheet.albedo.channels(); ++c) {
        surface.albedo.planes[std::size_t(c)](row, col) = float(albedo[c] / (k * k));
      }
    }
  });
  take_mean_height_off(surface.height, surface.mask);
  return surface;
}

}  // namespace hada
