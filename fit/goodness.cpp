#include "fit/goodness.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/field.h"

namespace hada {
namespace {

constexpr double growth = 0.3;        // size of a patch, as a share of its distance from 0
constexpr int sectors = 10;           // of patches, over the half plane
constexpr double fewest_shape = 6.0;  // independent ordinates that make a patch nearly chi-square

struct Patch {
  double count = 0.0;
  double ratio = 0.0;  // sum of count * P / S
};

/// Upper tail of the chi-square law. Source: Wilson and Hilferty, PNAS 17 (1931).
double chi_square_tail(double value, double freedom) {
  const double width = 2.0 / (9.0 * freedom);
  const double z = (std::cbrt(value / freedom) - (1.0 - width)) / std::sqrt(width);
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

}  // namespace

double goodness_of_fit(const std::vector<Cell>& cells, const std::vector<double>& model,
                       double independence, int fields) {
  std::map<std::pair<int, int>, Patch> patches;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const double turn = half_turn(std::atan2(cell.fy, cell.fx)) / std::numbers::pi;
    const int ring = int(std::floor(std::log(std::hypot(cell.fx, cell.fy)) / growth));
    Patch& patch = patches[{ring, int(turn * sectors)}];
    patch.count += cell.count;
    patch.ratio += cell.count * cell.power / model[i];
  }
  double sum = 0.0;
  int used = 0;
  for (const auto& [place, patch] : patches) {
    const double shape = independence * patch.count;
    if (shape < fewest_shape) continue;
    const double x = patch.ratio / patch.count;
    // The deviance of a gamma variable has mean 1 + 1 / (6 shape), to second order.
    sum += 2.0 * shape * (x - 1.0 - std::log(x)) / (1.0 + 1.0 / (6.0 * shape));
    ++used;
  }
  const int freedom = used - fields;
  if (freedom < 1) return std::numeric_limits<double>::quiet_NaN();
  return chi_square_tail(sum, freedom);
}

}  // namespace hada
