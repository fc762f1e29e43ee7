#include "fit/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/fft.h"
#include "core/field.h"

namespace hada {
namespace {

/// Of ordinates at whole steps of frequency: their sums are exact, so that cells of one shape have
/// one scatter to the last bit.
struct Sums {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;  // steps
  double power = 0.0, near = 0.0, far = 0.0;
  int count = 0;
  std::vector<int> ordinates;
};

Cell cell_from(const Sums& sums, const Spectrum& spectrum, double far_share) {
  const double n = sums.count;
  const double width = spectrum.extent.width(), height = spectrum.extent.height();
  constexpr double narrowing = 2.0 * std::numbers::pi * std::numbers::pi;
  const auto scatter = [n](double squares, double a, double b) {
    return narrowing * (n * squares - a * b) / (n * n);
  };
  return {.fx = sums.x / (n * width),
          .fy = sums.y / (n * height),
          .power = sums.power / n,
          .leakage = std::max(sums.far - far_share / (1.0 - far_share) * sums.near, 0.0) / n,
          .count = sums.count,
          .xx = spectrum.window_x + scatter(sums.xx, sums.x, sums.x) / (width * width),
          .xy = scatter(sums.xy, sums.x, sums.y) / (width * height),
          .yy = spectrum.window_y + scatter(sums.yy, sums.y, sums.y) / (height * height),
          .ordinates = sums.ordinates};
}

}  // namespace

std::vector<Cell> cells_of(const Spectrum& spectrum, const Leakage& leakage,
                           const CellOptions& options) {
  const Extent& extent = spectrum.extent;
  const double step = 1.0 / std::min(extent.width(), extent.height());
  const double inner = options.inner_bins * step;
  const int sectors = int(std::ceil(std::numbers::pi / options.growth));

  const double faintest =
      options.faintest * *std::max_element(leakage.near.begin(), leakage.near.end());

  std::vector<Cell> cells;
  const auto append = [&](const Sums& sums) {
    const double near = sums.near / sums.count, far = sums.far / sums.count;
    if (near > faintest && far <= options.most_leakage * (near + far))
      cells.push_back(cell_from(sums, spectrum, leakage.far_share));
  };
  const auto place_of = [&](int i, int k, double fx, double fy) {
    if (options.patch > 0) {
      return std::pair{int(std::floor(double(i) / options.patch)), k / options.patch};
    }
    const double turn = half_turn(std::atan2(fy, fx)) / std::numbers::pi;
    return std::pair{int(std::log(std::hypot(fx, fy) / inner) / options.growth),
                     int(turn * sectors)};
  };
  std::map<std::pair<int, int>, Sums> outer;  // by ring and sector, or by patch
  for (int row = 0; row < extent.rows; ++row) {
    const int i = signed_frequency(row, extent.rows);
    const double fy = spectrum.fy(row);
    for (int col = 0; col <= extent.cols / 2; ++col) {
      if (col == 0 && i < 0) continue;  // seen at (-i, 0)
      if (std::sqrt(double(i) * i + double(col) * col) < options.empty_steps) continue;
      const double fx = spectrum.fx(col);
      const double radius = std::sqrt(fx * fx + fy * fy);
      if (radius >= options.reach * 0.5 / extent.pitch) continue;
      const double power = spectrum.power(row, col);
      const double x = col, y = -i;  // fx, fy in steps; rows run downward
      const int ordinate = row * (extent.cols / 2 + 1) + col;
      const double near = leakage.near(row, col), far = leakage.far(row, col);
      if (radius < inner) {
        append({x, y, x * x, x * y, y * y, power, near, far, 1, {ordinate}});
        continue;
      }
      Sums& sums = outer[place_of(i, col, fx, fy)];
      // A cell may straddle the edge of the half plane only through f = -f: turn to one side.
      const double side = fy < 0.0 ? -1.0 : 1.0;
      sums.x += side * x;
      sums.y += side * y;
      sums.xx += x * x;
      sums.xy += x * y;
      sums.yy += y * y;
      sums.power += power;
      sums.near += near;
      sums.far += far;
      ++sums.count;
      sums.ordinates.push_back(ordinate);
    }
  }
  for (const auto& [place, sums] : outer) append(sums);
  return cells;
}

}  // namespace hada
