#include "synth/blade.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double back_thickness = 0.85;  // of that at the ridge

/// The blade at one place along it.
struct Station {
  double x;
  double edge;  // y of the edge and of the back
  double back;
  double half_thickness;  // at the ridge
};

Station station_at(const BladeShape& b, double u) {
  const double x = u * b.length_mm;
  const double bow = b.curvature_mm * 4.0 * u * (1.0 - u);
  const double body = std::max(b.length_mm - b.point_mm, 1e-9);
  const double taper = std::min(x / body, 1.0);
  const double width = b.width_mm + taper * (b.tip_width_mm - b.width_mm);
  // The point: the edge rounds up to the back.
  const double into = std::clamp((x - body) / std::max(b.point_mm, 1e-9), 0.0, 1.0);
  const double left = std::sqrt(1.0 - into * into);
  const double back = 0.5 * b.width_mm - bow;
  return {x, back - width * left, back, 0.5 * b.thickness_mm * width / b.width_mm * left};
}

/// Places across one side from edge to back, as shares of the width and of the thickness.
struct Across {
  double v;
  double thickness;
};

/// A number between -1 and 1 that wanders with `x`: cosines between values at whole places.
double wandering(Seed seed, int kind, double x) {
  const double place = std::floor(x), part = x - place;
  const auto at = [&](double k) { return 2.0 * uniform(seed, std::int64_t(k), kind) - 1.0; };
  const double ease = 0.5 - 0.5 * std::cos(pi * part);
  return (1.0 - ease) * at(place) + ease * at(place + 1.0);
}

/// `row` reflected into [0, rows - 1].
double reflected(double row, int rows) {
  const double period = 2.0 * (rows - 1);
  const double rest = std::abs(std::remainder(row, period));
  return std::min(rest, double(rows - 1));
}

}  // namespace

TriangleMesh blade_mesh(const BladeShape& shape) {
  const Across across[] = {
      {0.0, 0.0}, {0.5 * shape.ridge, 0.52}, {shape.ridge, 1.0}, {1.0, back_thickness}};
  constexpr int lines = 4;
  TriangleMesh mesh;
  for (const double side : {1.0, -1.0}) {
    for (int k = 0; k <= shape.segments; ++k) {
      const double u = double(k) / shape.segments;
      const Station s = station_at(shape, u);
      for (const Across& a : across) {
        mesh.vertices_mm.emplace_back(s.x, s.edge + a.v * (s.back - s.edge),
                                      side * a.thickness * s.half_thickness);
        mesh.uv.emplace_back(u, a.v);
      }
    }
  }
  const auto add = [&](int a, int b, int c) {
    const auto& v = mesh.vertices_mm;
    const auto area =
        (v[std::size_t(b)] - v[std::size_t(a)]).cross(v[std::size_t(c)] - v[std::size_t(a)]).norm();
    if (area > 1e-9) mesh.triangles.push_back({a, b, c});  // the point closes to one place
  };
  const auto quad = [&](int a, int b, int c, int d) {
    add(a, b, c);
    add(a, c, d);
  };
  const int one_side = (shape.segments + 1) * lines;
  const auto at = [&](int side, int k, int line) { return side * one_side + k * lines + line; };
  for (int k = 0; k < shape.segments; ++k) {
    for (int line = 0; line + 1 < lines; ++line) {
      quad(at(0, k, line), at(0, k + 1, line), at(0, k + 1, line + 1), at(0, k, line + 1));
      quad(at(1, k, line), at(1, k, line + 1), at(1, k + 1, line + 1), at(1, k + 1, line));
    }
    const int last = lines - 1;
    quad(at(0, k, last), at(0, k + 1, last), at(1, k + 1, last), at(1, k, last));
  }
  for (int line = 0; line + 1 < lines; ++line)
    quad(at(0, 0, line), at(0, 0, line + 1), at(1, 0, line + 1), at(1, 0, line));
  return mesh;
}

Grid<float> hamon_mask(int rows, int cols, const HamonShape& shape, Seed seed) {
  Grid<float> mask(rows, cols);
  if (!(shape.height > 0.0)) return mask;
  std::vector<double> border;
  for (int col = 0; col < cols; ++col) {
    const double turn = shape.waves * (col + 0.5) / cols;
    const double height = 1.0 + 0.5 * wandering(seed, 1, 0.7 * turn);
    border.push_back(shape.height +
                     shape.wave * height * std::sin(2.0 * pi * turn + wandering(seed, 2, turn)));
  }
  const double mist = std::max(shape.mist, 0.5 / rows);
  for_each_index(rows, [&](int row) {
    const double v = 1.0 - (row + 0.5) / rows;
    for (int col = 0; col < cols; ++col) {
      const double above = (v - border[std::size_t(col)]) / mist;
      mask(row, col) = float(0.5 - 0.5 * std::tanh(2.0 * above));
    }
  });
  return mask;
}

Grid<float> ayasugi(const Grid<float>& grain, const AyasugiShape& shape) {
  if (!(shape.wavelength > 0.0)) return grain;
  std::vector<double> moved;
  for (int col = 0; col < grain.cols(); ++col) {
    const double turn = 2.0 * pi * col / shape.wavelength;
    // Two overtones make a sawtooth whose corners are round.
    const double wave =
        shape.twisted
            ? 0.8 * (std::sin(turn) - 0.5 * std::sin(2.0 * turn) + std::sin(3.0 * turn) / 3.0)
            : std::cos(turn);
    moved.push_back(shape.amplitude * std::min(wave, 1.0 - shape.depth));
  }
  Grid<float> waved(grain.rows(), grain.cols());
  for_each_index(grain.rows(), [&](int row) {
    for (int col = 0; col < grain.cols(); ++col) {
      const double from = reflected(row + moved[std::size_t(col)], grain.rows());
      const int first = std::min(int(from), std::max(grain.rows() - 2, 0));
      const float part = float(from - first);
      const int next = std::min(first + 1, grain.rows() - 1);
      waved(row, col) = (1.0f - part) * grain(first, col) + part * grain(next, col);
    }
  });
  return waved;
}

}  // namespace hada
