#include "sheet/crossing.h"

#include <cmath>

#include <Eigen/Geometry>

namespace hada {
namespace {

using Eigen::Vector3d;

struct Plate {
  std::vector<Vector3d> corners;
  Vector3d normal;
  Vector3d low, high;
};

std::vector<Plate> plates_of(const Sheet& sheet) {
  std::vector<Plate> plates;
  for (int f = 0; f < sheet.faces(); ++f) {
    Plate plate;
    for (const int v : sheet.corners_of(f)) plate.corners.push_back(sheet.folded[std::size_t(v)]);
    Vector3d sum = Vector3d::Zero();
    plate.low = plate.high = plate.corners[0];
    for (std::size_t i = 0; i < plate.corners.size(); ++i) {
      const Vector3d& next = plate.corners[(i + 1) % plate.corners.size()];
      sum += (plate.corners[i] - plate.corners[0]).cross(next - plate.corners[0]);
      plate.low = plate.low.cwiseMin(plate.corners[i]);
      plate.high = plate.high.cwiseMax(plate.corners[i]);
    }
    plate.normal = sum.normalized();
    plates.push_back(std::move(plate));
  }
  return plates;
}

// Whether a side of `one` goes through the inside of `other`.
bool pierces(const Plate& one, const Plate& other, double tolerance) {
  for (std::size_t i = 0; i < one.corners.size(); ++i) {
    const Vector3d& a = one.corners[i];
    const Vector3d& b = one.corners[(i + 1) % one.corners.size()];
    const double da = other.normal.dot(a - other.corners[0]);
    const double db = other.normal.dot(b - other.corners[0]);
    if (std::min(da, db) > -tolerance || std::max(da, db) < tolerance) continue;
    const Vector3d place = a + (b - a) * (da / (da - db));
    bool inside = true;
    for (std::size_t k = 0; k < other.corners.size() && inside; ++k) {
      const Vector3d& c = other.corners[k];
      const Vector3d way = (other.corners[(k + 1) % other.corners.size()] - c).normalized();
      inside = other.normal.dot(way.cross(place - c)) > tolerance;
    }
    if (inside) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<int, 2>> crossing_faces(const Sheet& sheet, double tolerance) {
  const auto plates = plates_of(sheet);
  std::vector<std::array<int, 2>> crossing;
  for (std::size_t a = 0; a < plates.size(); ++a) {
    for (std::size_t b = a + 1; b < plates.size(); ++b) {
      const Plate &one = plates[a], &two = plates[b];
      const bool apart =
          (one.low.array() > two.high.array()).any() || (two.low.array() > one.high.array()).any();
      if (apart) continue;
      if (pierces(one, two, tolerance) || pierces(two, one, tolerance)) {
        crossing.push_back({int(a), int(b)});
      }
    }
  }
  return crossing;
}

}  // namespace hada
