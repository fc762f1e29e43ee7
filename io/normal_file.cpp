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

// What the vectors of a map are like, as they are read.
struct Tally {
  std::size_t long_enough = 0;  // neither near 0 nor far longer than 1
  std::size_t away = 0;         // of those
  std::size_t off_length = 0;   // of those that are not away
  std::size_t unit = 0;         // floats as long as normals are
  std::size_t coded_unit = 0;   // floats that would be, if (n + 1) / 2 were stored

  std::size_t normals() const { return long_enough - away; }
};

Eigen::Vector3f decoded(const Eigen::Vector3f& stored) {
  return 2.0f * stored - Eigen::Vector3f::Ones();
}

bool has_unit_length(const Eigen::Vector3f& vector) {
  return std::abs(vector.norm() - 1.0f) < 0.1f;
}

// A unit vector that looks towards the camera; nothing if the pixel holds none.
std::optional<Eigen::Vector3f> normal_of(const float* pixel, const PictureShape& shape, bool y_down,
                                         Tally& tally) {
  Eigen::Vector3f normal(pixel[0], pixel[1], pixel[2]);
  if (shape.floating) {
    tally.unit += has_unit_length(normal) ? 1 : 0;
    tally.coded_unit += has_unit_length(decoded(normal)) ? 1 : 0;
  } else {
    normal = decoded(normal);
  }
  if (y_down) normal.y() = -normal.y();
  const float length = normal.norm();
  if (!(length > 0.5f && length < 1.5f)) return {};  // also not a number
  ++tally.long_enough;
  const bool is_off = !has_unit_length(normal);
  normal /= length;
  if (normal.z() <= -outline) {
    ++tally.away;
    return {};
  }
  tally.off_length += is_off ? 1 : 0;
  normal.z() = std::max(normal.z(), least_z);
  return normal.normalized();
}

void require_normals(const std::filesystem::path& path, const Tally& tally, std::size_t pixels) {
  if (tally.coded_unit > 2 * tally.unit && tally.coded_unit > tally.long_enough / 2) {
    throw Error(
        path.string() +
        ": holds floats that are unit vectors if they are taken for (n + 1) / 2; floats must "
        "be signed, so write 2 v - 1, or integers");
  }
  if (double(tally.normals()) < least_share * double(pixels)) {
    throw Error(path.string() +
                ": hardly any pixel holds a unit vector that looks towards the camera; floats must "
                "be signed, integers encode -1 to 1" +
                (tally.away > tally.normals() ? "; turn z round if it points away" : ""));
  }
}

}  // namespace

NormalFile read_normals(
    const std::filesystem::path& path, bool y_down,
    const std::function<std::pmr::memory_resource*(const PictureShape&)>& memory) {
  NormalFile result;
  PictureShape shape;
  Tally tally;
  const auto begin = [&](const PictureShape& found) {
    shape = found;
    if (shape.channels != 3) {
      throw Error(path.string() + ": a normal map has three channels x, y, z, this has fewer");
    }
    std::pmr::memory_resource* const where = memory ? memory(shape) : nullptr;
    result.normals = NormalMap(shape.rows, shape.cols, Eigen::Vector3f::UnitZ(), where);
    result.mask = Mask(shape.rows, shape.cols, 0, where);
    return true;
  };
  const auto take_row = [&](int row, const float* pixels) {
    for (int col = 0; col < shape.cols; ++col) {
      const auto normal = normal_of(pixels + 3 * col, shape, y_down, tally);
      if (!normal) continue;
      result.normals(row, col) = *normal;
      result.mask(row, col) = 1;
    }
  };
  read_rows(path, {begin, take_row});
  require_normals(path, tally, result.mask.size());
  result.share_away = double(tally.away) / double(tally.long_enough);
  result.share_off_length = double(tally.off_length) / double(tally.normals());
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
