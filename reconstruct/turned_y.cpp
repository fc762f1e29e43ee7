#include "reconstruct/turned_y.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/quantile.h"

namespace hada {
namespace {

// What the slopes along x, and those along y, add up to round a square.
struct Circulation {
  double along_x = 0.0;
  double along_y = 0.0;
};

// Round the square of `side` steps whose upper left pixel is (row, col); nothing if it leaves the
// mask. y is up, so the upper row comes first.
std::optional<Circulation> circulation(const NormalMap& normals, const Mask& mask, int row, int col,
                                       int side) {
  Circulation sum;
  const auto add = [&](int r, int c, int axis, double share, double& to) {
    if (!mask(r, c)) return false;
    const Eigen::Vector3f& n = normals(r, c);
    to -= share * double(n[axis]) / double(n.z());
    return true;
  };
  for (int i = 0; i <= side; ++i) {
    const double share = i == 0 || i == side ? 0.5 : 1.0;  // the trapezoidal rule
    const bool inside = add(row, col + i, 0, share, sum.along_x) &&
                        add(row + side, col + i, 0, -share, sum.along_x) &&
                        add(row + i, col + side, 1, share, sum.along_y) &&
                        add(row + i, col, 1, -share, sum.along_y);
    if (!inside) return {};
  }
  return sum;
}

// Of squares of one size; nothing if there are hardly any.
std::optional<double> gain(const NormalMap& normals, const Mask& mask, int side) {
  constexpr int enough_rows = 512;
  const std::size_t enough = side > 1 ? 64 : 1;  // their medians scatter by a third then
  const int step = std::max(side, mask.rows() / enough_rows);
  std::vector<float> given, turned;  // squares of the circulation
  for (int row = 0; row + side < mask.rows(); row += step) {
    for (int col = 0; col + side < mask.cols(); col += side) {
      const auto found = circulation(normals, mask, row, col, side);
      if (!found) continue;
      given.push_back(float(std::pow(found->along_x - found->along_y, 2)));
      turned.push_back(float(std::pow(found->along_x + found->along_y, 2)));
    }
  }
  if (given.size() < enough) return {};
  const float nothing = 1e-12f;  // rounding
  return double(median(std::move(given)) + nothing) / double(median(std::move(turned)) + nothing);
}

}  // namespace

double gain_of_turned_y(const NormalMap& normals, const Mask& mask) {
  assert(normals.same_size(mask));
  double clearest = 1.0;
  for (const int side : {1, 4, 16}) {
    const double found = gain(normals, mask, side).value_or(1.0);
    if (std::abs(std::log(found)) > std::abs(std::log(clearest))) clearest = found;
  }
  return clearest;
}

}  // namespace hada
