#include "io/normal_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/error.h"
#include "io/image_file.h"

namespace hada {
namespace {

constexpr double least_share = 0.01;  // of the pixels that must hold a normal

// Perspective and rounding turn a normal at an outline a little away from the optical axis.
constexpr float outline = 0.1f;
constexpr float least_z = 1e-3f;

}  // namespace

NormalFile read_normals(const std::filesystem::path& path, bool y_down) {
  const ImageFile file = read_image(path);
  const auto& planes = file.image.planes;
  if (planes.size() != 3) {
    throw Error(path.string() + ": a normal map has three channels x, y, z, this has one");
  }
  const int rows = planes[0].rows();
  const int cols = planes[0].cols();
  NormalFile result{NormalMap(rows, cols, Eigen::Vector3f::UnitZ()), Mask(rows, cols, 0)};
  std::size_t count = 0;
  for (std::size_t i = 0; i < planes[0].size(); ++i) {
    Eigen::Vector3f normal(planes[0][i], planes[1][i], planes[2][i]);
    if (!file.floating) normal = 2.0f * normal - Eigen::Vector3f::Ones();
    if (y_down) normal.y() = -normal.y();
    const float length = normal.norm();
    if (!(length > 0.5f && length < 1.5f)) continue;  // also not a number
    normal /= length;
    if (normal.z() <= -outline) continue;
    normal.z() = std::max(normal.z(), least_z);
    result.normals[i] = normal.normalized();
    result.mask[i] = 1;
    ++count;
  }
  if (double(count) < least_share * double(result.mask.size())) {
    throw Error(path.string() +
                ": hardly any pixel holds a unit vector that looks towards the camera; floats must "
                "be signed, integers encode -1 to 1");
  }
  return result;
}

Eigen::Matrix3d read_intrinsics(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw Error(path.string() + ": cannot be read; give a text file with nine numbers");
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
