#include "io/normal_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "core/error.h"

namespace hada {
namespace {

constexpr double least_share = 0.01;  // of the pixels that must hold a normal

// Perspective and rounding turn a normal at an outline a little away from the optical axis.
constexpr float outline = 0.1f;
constexpr float least_z = 1e-3f;

// A unit vector that looks towards the camera; nothing if the pixel holds none.
std::optional<Eigen::Vector3f> normal_of(const float* pixel, const PictureShape& shape,
                                         bool y_down) {
  Eigen::Vector3f normal(pixel[0], pixel[1], pixel[2]);
  if (!shape.floating) normal = 2.0f * normal - Eigen::Vector3f::Ones();
  if (y_down) normal.y() = -normal.y();
  const float length = normal.norm();
  if (!(length > 0.5f && length < 1.5f)) return {};  // also not a number
  normal /= length;
  if (normal.z() <= -outline) return {};
  normal.z() = std::max(normal.z(), least_z);
  return normal.normalized();
}

}  // namespace

NormalFile read_normals(
    const std::filesystem::path& path, bool y_down,
    const std::function<std::pmr::memory_resource*(const PictureShape&)>& memory) {
  NormalFile result;
  PictureShape shape;
  std::size_t count = 0;
  const auto begin = [&](const PictureShape& found) {
    shape = found;
    if (shape.channels != 3) {
      throw Error(path.string() + ": a normal map has three channels x, y, z, this has one");
    }
    std::pmr::memory_resource* const where = memory ? memory(shape) : nullptr;
    result.normals = NormalMap(shape.rows, shape.cols, Eigen::Vector3f::UnitZ(), where);
    result.mask = Mask(shape.rows, shape.cols, 0, where);
    return true;
  };
  const auto take_row = [&](int row, const float* pixels) {
    for (int col = 0; col < shape.cols; ++col) {
      const auto normal = normal_of(pixels + 3 * col, shape, y_down);
      if (!normal) continue;
      result.normals(row, col) = *normal;
      result.mask(row, col) = 1;
      ++count;
    }
  };
  read_rows(path, {begin, take_row});
  if (double(count) < least_share * double(result.mask.size())) {
    throw Error(path.string() +
                ": hardly any pixel holds a unit vector that looks towards the camera; floats must "
                "be signed, integers encode -1 to 1");
  }
  return result;
}

Grid<float> read_plane(const std::filesystem::path& path, const Mask& size) {
  Grid<float> plane(size.rows(), size.cols(), 0.0f, size.memory());
  int channels = 1;
  const auto begin = [&](const PictureShape& shape) {
    if (shape.rows != size.rows() || shape.cols != size.cols()) {
      throw Error(path.string() + ": is " + std::to_string(shape.cols) + " x " +
                  std::to_string(shape.rows) + " pixels, but the normal map " +
                  std::to_string(size.cols()) + " x " + std::to_string(size.rows()));
    }
    channels = shape.channels;
    return true;
  };
  const auto take_row = [&](int row, const float* pixels) {
    for (float& value : plane.row(row)) {
      value = channels == 3 ? (pixels[0] + pixels[1] + pixels[2]) / 3.0f : pixels[0];
      pixels += channels;
    }
  };
  read_rows(path, {begin, take_row});
  return plane;
}

Eigen::Matrix3d read_intrinsics(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw Error(path.string() + ": cannot be read; give a text file with nine numbers");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  // However they are parted: by spaces, commas, semicolons, or as a list of lists.
  for (char& c : text) {
    if (std::string_view(",;[]()").find(c) != std::string_view::npos) c = ' ';
  }
  std::istringstream in(text);
  Eigen::Matrix3d k;
  for (int i = 0; i < 9; ++i) {
    if (!(in >> k(i / 3, i % 3)) || !std::isfinite(k(i / 3, i % 3))) {
      throw Error(path.string() + ": must hold nine numbers, fx 0 cx, 0 fy cy, 0 0 1");
    }
  }
  std::string more;
  const bool is_camera = k(0, 0) > 0.0 && k(1, 1) > 0.0 && k(0, 1) == 0.0 && k(1, 0) == 0.0 &&
                         k(2, 0) == 0.0 && k(2, 1) == 0.0 && k(2, 2) == 1.0;
  if (!is_camera || in >> more) {
    throw Error(
        path.string() +
        ": is not the matrix of a camera without skew, fx 0 cx, 0 fy cy, 0 0 1 with fx, fy > 0");
  }
  return k;
}

}  // namespace hada
