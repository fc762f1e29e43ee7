#include "fit/further_rings.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/ring_edges.h"
#include "measure/line_field.h"

namespace hada {
namespace {

constexpr int cell_px = 16;           // within which rho is taken to be as sure as in the middle
constexpr double most_sigma = 0.2;    // of the distance of rings, of a rho that counts
constexpr double line_share = 0.12;   // of the distance of rings: Gaussian of a dark line
constexpr double bins_a_ring = 24.0;  // of the profile
constexpr int fewest_pixels = 30;     // of a bin
constexpr double faint = 0.5;         // of the usual strength
constexpr double apart = 0.55;        // of the distance of rings, from those that are known
constexpr double farthest = 1.5;      // the same, at most

/// Sums of what pixels show, by effective radius.
struct Gathered {
  double first = 0.0, step = 1.0;
  std::vector<double> sum;
  std::vector<int> count;
};

void gather(const BlockFace& face, const GrowthSolid& solid, double width, Gathered& all) {
  const Extent& extent = face.extent;
  const Grid<float> ground = smoothed(face.absorbance, face.wood, width / extent.pitch);
  const int cells = (extent.rows + cell_px - 1) / cell_px;
  std::vector<std::vector<std::pair<double, double>>> seen(static_cast<std::size_t>(cells));
  for_each_index(cells, [&](int cell) {
    for (int left = 0; left < extent.cols; left += cell_px) {
      const int top = cell * cell_px;
      const Eigen::Vector2d middle = extent.place(top + cell_px / 2, left + cell_px / 2);
      const SolidLocal local = local_of(solid, face.cut.at(middle.x(), middle.y()));
      if (rho_sigma(solid, local) > most_sigma * width) continue;
      for (int row = top; row < std::min(top + cell_px, extent.rows); row += 2) {
        for (int col = left; col < std::min(left + cell_px, extent.cols); ++col) {
          if (!face.wood(row, col)) continue;
          const Eigen::Vector2d place = extent.place(row, col);
          seen[std::size_t(cell)].push_back(
              {local_of(solid, face.cut.at(place.x(), place.y()), false).rho,
               double(face.absorbance(row, col) - ground(row, col))});
        }
      }
    }
  });
  for (const auto& row : seen) {
    for (const auto& [rho, value] : row) {
      const double bin = std::floor((rho - all.first) / all.step);
      if (!(bin >= 0.0) || bin >= double(all.sum.size())) continue;
      all.sum[std::size_t(bin)] += value;
      ++all.count[std::size_t(bin)];
    }
  }
}

}  // namespace

std::vector<double> further_rings(const std::vector<BlockFace>& faces, const GrowthSolid& solid) {
  const auto& radii = solid.radii;
  if (radii.size() < 3) return {};
  const double width = usual_width(solid);
  Gathered all;
  all.step = width / bins_a_ring;
  const double reach = radii.back() - radii.front() + 2.0 * width;
  all.first = std::max(0.0, radii.front() - reach);
  const auto bins = std::size_t((radii.back() + reach - all.first) / all.step);
  all.sum.assign(bins, 0.0);
  all.count.assign(bins, 0);
  for (const BlockFace& face : faces) gather(face, solid, width, all);

  std::vector<float> profile(bins);
  for (std::size_t i = 0; i < bins; ++i)
    profile[i] = all.count[i] >= fewest_pixels ? float(all.sum[i] / all.count[i]) : std::nanf("");
  const double blur = line_share * width / std::sqrt(2.0) / all.step;
  const auto once = slopes_along(profile, 1.0, blur);
  const std::vector<float> slopes(once.begin(), once.end());
  const auto lines = slopes_along(slopes, 1.0, blur);
  const auto strength_at = [&](double radius) {
    double best = 0.0;
    for (double by = -0.2; by <= 0.2; by += 0.02) {
      const double bin = (radius + by * width - all.first) / all.step;
      if (bin < 0.0 || bin >= double(bins)) continue;
      const double value = lines[std::size_t(bin)];
      if (value > best) best = value;
    }
    return best;
  };
  std::vector<double> usual;
  for (const double radius : radii) usual.push_back(strength_at(radius));
  const double least = faint * median(std::move(usual));
  // From the inside out, and only near those that are known, to which each that is found is added:
  // what lies beyond a wide gap may be the next but one.
  std::vector<double> found, known = radii;
  const auto distance = [&](double radius) {
    double least_distance = HUGE_VAL;
    for (const double one : known)
      least_distance = std::min(least_distance, std::abs(one - radius));
    return least_distance / width;
  };
  for (std::size_t i = 1; i + 1 < bins; ++i) {
    if (!(lines[i] >= least) || !(lines[i] >= lines[i - 1]) || !(lines[i] > lines[i + 1])) continue;
    const double radius = all.first + (double(i) + 0.5) * all.step;
    if (distance(radius) < apart || distance(radius) > farthest) continue;
    found.push_back(radius);
    known.push_back(radius);
  }
  return found;
}

}  // namespace hada
