#include "app/draw/sheet_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "app/draw/palette.h"
#include "core/grid.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int finer = 3;  // samples along each side of a pixel

struct Shape {
  std::vector<Vector3d> corners;  // x right, y up in samples; z towards the viewer
  Vector3d normal;
};

struct Layers {
  std::map<std::pair<int, int>, int> order;
  const std::vector<Shape>& shapes;

  // Whether face a hides face b where both lie at one depth.
  bool hides(int a, int b) const {
    if (const auto found = order.find({a, b}); found != order.end()) {
      return found->second * shapes[std::size_t(b)].normal.z() > 0.0;
    }
    if (const auto found = order.find({b, a}); found != order.end()) {
      return found->second * shapes[std::size_t(a)].normal.z() < 0.0;
    }
    return a > b;
  }
};

Colour colour_of(const Shape& shape) {
  const bool printed = shape.normal.z() > 0.0;
  const Vector3d up = printed ? shape.normal : Vector3d(-shape.normal);
  const double shade = 0.72 + 0.28 * std::clamp(up.dot(Vector3d(-0.5, 0.6, 0.62)), 0.0, 1.0);
  const Colour paper = printed ? Colour{0.93f, 0.45f, 0.28f} : Colour{0.97f, 0.96f, 0.93f};
  return {float(paper[0] * shade), float(paper[1] * shade), float(paper[2] * shade)};
}

std::vector<Shape> shapes_of(const FoldFrame& folded, const SheetView& view, int& rows, int& cols) {
  constexpr double degree = std::numbers::pi / 180.0;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(-view.tilt_deg * degree, Vector3d::UnitX()) *
                                Eigen::AngleAxisd(view.turn_deg * degree, Vector3d::UnitY()) *
                                Eigen::AngleAxisd(view.roll_deg * degree, Vector3d::UnitZ()))
                                   .toRotationMatrix();
  std::vector<Vector3d> places;
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (const Vector3d& p : folded.vertices) {
    places.push_back(turn * p);
    low = low.cwiseMin(places.back());
    high = high.cwiseMax(places.back());
  }
  const double margin = 0.05 * (high - low).head<2>().maxCoeff();
  const double scale =
      finer * view.size_px / std::max((high - low).head<2>().maxCoeff() + 2.0 * margin, 1e-300);
  cols = std::max(1, int(((high - low).x() + 2.0 * margin) * scale / finer));
  rows = std::max(1, int(((high - low).y() + 2.0 * margin) * scale / finer));
  for (Vector3d& p : places) p = (p - low + Vector3d(margin, margin, 0.0)) * scale;
  std::vector<Shape> shapes;
  for (const auto& face : folded.faces) {
    Shape shape;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      shape.corners.push_back(places[std::size_t(face[i])]);
      const Vector3d& first = places[std::size_t(face[0])];
      sum += (shape.corners.back() - first)
                 .cross(places[std::size_t(face[(i + 1) % face.size()])] - first);
    }
    shape.normal = sum.norm() > 0.0 ? Vector3d(sum.normalized()) : Vector3d::UnitX();
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

bool covers(const Shape& shape, const Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = shape.corners.size() - 1; i < shape.corners.size(); j = i++) {
    const Vector3d &a = shape.corners[i], &b = shape.corners[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) inside = !inside;
  }
  return inside;
}

}  // namespace

Image sheet_picture(const FoldFrame& folded, const SheetView& view) {
  int rows = 0, cols = 0;
  const auto shapes = shapes_of(folded, view, rows, cols);
  Layers layers{{}, shapes};
  for (const FaceOrder& o : folded.face_orders) layers.order[{o.face, o.other}] = o.order;
  Grid<int> top(finer * rows, finer * cols, -1);
  Grid<float> depth(finer * rows, finer * cols, 0.0f);
  constexpr double one_depth = 0.02 * finer;  // samples: rounding of what lies in one plane
  for (int f = 0; f < int(shapes.size()); ++f) {
    const Shape& shape = shapes[std::size_t(f)];
    if (std::abs(shape.normal.z()) < 1e-6) continue;
    Vector3d low = shape.corners[0], high = low;
    for (const Vector3d& p : shape.corners) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const int first = std::max(0, top.rows() - 1 - int(high.y()));
    const int last = std::min(top.rows() - 1, top.rows() - 1 - int(low.y()));
    for (int row = first; row <= last; ++row) {
      for (int col = std::max(0, int(low.x())); col <= std::min(top.cols() - 1, int(high.x()));
           ++col) {
        const Vector2d p(col + 0.5, top.rows() - row - 0.5);
        if (!covers(shape, p)) continue;
        const double z =
            shape.corners[0].z() -
            shape.normal.head<2>().dot(p - shape.corners[0].head<2>()) / shape.normal.z();
        const int other = top(row, col);
        const bool nearer = other < 0 || z > depth(row, col) + one_depth ||
                            (z > depth(row, col) - one_depth && layers.hides(f, other));
        if (!nearer) continue;
        top(row, col) = f;
        depth(row, col) = float(z);
      }
    }
  }
  Image image(rows, cols, 3);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      std::array<float, 3> sum{};
      for (int k = 0; k < finer * finer; ++k) {
        const int r = finer * row + k / finer, c = finer * col + k % finer;
        const int f = top(r, c);
        Colour colour = f < 0 ? Colour{1.0f, 1.0f, 1.0f} : colour_of(shapes[std::size_t(f)]);
        const int right = c + 1 < top.cols() ? top(r, c + 1) : f;
        const int below = r + 1 < top.rows() ? top(r + 1, c) : f;
        const int left = c > 0 ? top(r, c - 1) : f, above = r > 0 ? top(r - 1, c) : f;
        if (f != right || f != below || f != left || f != above) colour = {0.2f, 0.2f, 0.22f};
        for (std::size_t i = 0; i < 3; ++i) sum[i] += colour[i] / (finer * finer);
      }
      for (std::size_t i = 0; i < 3; ++i) image.planes[i](row, col) = sum[i];
    }
  }
  return image;
}

}  // namespace hada
