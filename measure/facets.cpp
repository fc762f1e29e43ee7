#include "measure/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/quantile.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Slopes = Grid<Vector2d>;

Slopes slopes_of(const NormalMap& normals, const Mask& mask) {
  Slopes slopes(mask.rows(), mask.cols(), Vector2d::Zero());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) slopes[i] = -(normals[i].head<2>() / normals[i].z()).cast<double>();
  }
  return slopes;
}

// The standard deviation of one slope of one pixel, from neighbours: creases are few.
double noise_of(const Slopes& slopes, const Mask& mask) {
  std::vector<double> steps;
  for (int row = 0; row < mask.rows(); row += 2) {
    for (int col = 0; col + 1 < mask.cols(); col += 2) {
      if (!mask(row, col) || !mask(row, col + 1)) continue;
      const Vector2d step = slopes(row, col + 1) - slopes(row, col);
      steps.push_back(std::abs(step.x()));
      steps.push_back(std::abs(step.y()));
    }
  }
  constexpr double sigma_of_median = 1.4826;
  return steps.empty() ? 0.0 : sigma_of_median * median(std::move(steps)) / std::numbers::sqrt2;
}

// Means over windows of 2 r + 1 pixels, of the pixels in the mask.
class WindowMeans {
 public:
  WindowMeans(const Slopes& slopes, const Mask& mask, int reach)
      : reach_(reach), sums_(mask.rows() + 1, mask.cols() + 1, Eigen::Vector3d::Zero()) {
    for (int row = 0; row < mask.rows(); ++row) {
      Eigen::Vector3d along = Eigen::Vector3d::Zero();
      for (int col = 0; col < mask.cols(); ++col) {
        if (mask(row, col)) along += Eigen::Vector3d(slopes(row, col).x(), slopes(row, col).y(), 1);
        sums_(row + 1, col + 1) = sums_(row, col + 1) + along;
      }
    }
  }
  /// x, y: the mean slope; z: the share of the window that lies in the mask.
  Eigen::Vector3d at(int row, int col) const {
    const int rows = sums_.rows() - 1, cols = sums_.cols() - 1;
    const int top = std::clamp(row - reach_, 0, rows),
              bottom = std::clamp(row + reach_ + 1, 0, rows);
    const int left = std::clamp(col - reach_, 0, cols),
              right = std::clamp(col + reach_ + 1, 0, cols);
    const Eigen::Vector3d sum =
        sums_(bottom, right) - sums_(top, right) - sums_(bottom, left) + sums_(top, left);
    const double side = 2.0 * reach_ + 1.0;
    if (sum.z() < 0.5) return Eigen::Vector3d::Zero();
    return {sum.x() / sum.z(), sum.y() / sum.z(), sum.z() / (side * side)};
  }

 private:
  int reach_;
  Grid<Eigen::Vector3d> sums_;
};

// 1 where windows on either side, in four directions, agree.
Mask flat_pixels(const WindowMeans& means, const Mask& mask, int reach, double allowed) {
  Mask flat(mask.rows(), mask.cols(), 0);
  constexpr double enough = 0.25;  // of a window inside the mask
  const int far = reach + 1;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      bool same = true;
      for (const auto& [down, right] : {std::pair{0, far}, {far, 0}, {far, far}, {far, -far}}) {
        const auto one = means.at(row + down, col + right),
                   other = means.at(row - down, col - right);
        if (one.z() < enough || other.z() < enough) continue;
        same = same && (one - other).head<2>().norm() < allowed;
      }
      flat(row, col) = same;
    }
  }
  return flat;
}

// Connected pixels of `flat`, numbered from 0; -1 elsewhere.
Grid<int> connected(const Mask& flat, std::vector<int>& sizes) {
  Grid<int> label(flat.rows(), flat.cols(), -1);
  std::vector<std::pair<int, int>> open;
  for (int row = 0; row < flat.rows(); ++row) {
    for (int col = 0; col < flat.cols(); ++col) {
      if (!flat(row, col) || label(row, col) >= 0) continue;
      const int number = int(sizes.size());
      sizes.push_back(0);
      label(row, col) = number;
      open.push_back({row, col});
      while (!open.empty()) {
        const auto [r, c] = open.back();
        open.pop_back();
        ++sizes.back();
        for (const auto& [dr, dc] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
          if (!flat.contains(r + dr, c + dc) || !flat(r + dr, c + dc)) continue;
          if (label(r + dr, c + dc) >= 0) continue;
          label(r + dr, c + dc) = number;
          open.push_back({r + dr, c + dc});
        }
      }
    }
  }
  return label;
}

// Mean slopes, and their sigma from the scatter of squares of the facet: neighbours may err alike.
std::vector<Facet> measured(const Slopes& slopes, const Grid<int>& label, int count, int square) {
  std::vector<Facet> facets(static_cast<std::size_t>(count));
  const int across = label.cols() / square + 1;
  struct Sum {
    Vector2d slope = Vector2d::Zero();
    int pixels = 0;
  };
  std::vector<std::vector<Sum>> squares(
      std::size_t(count), std::vector<Sum>(std::size_t(across * (label.rows() / square + 1))));
  for (int row = 0; row < label.rows(); ++row) {
    for (int col = 0; col < label.cols(); ++col) {
      if (label(row, col) < 0) continue;
      const std::size_t f = std::size_t(label(row, col));
      facets[f].slope += slopes(row, col);
      ++facets[f].pixels;
      Sum& sum = squares[f][std::size_t(row / square * across + col / square)];
      sum.slope += slopes(row, col);
      ++sum.pixels;
    }
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    Facet& facet = facets[f];
    facet.slope /= std::max(facet.pixels, 1);
    double scatter = 0.0;
    int used = 0;
    for (const Sum& sum : squares[f]) {
      if (sum.pixels < square * square / 2) continue;
      scatter += (sum.slope / sum.pixels - facet.slope).squaredNorm() / 2.0;
      ++used;
    }
    if (used > 1) facet.sigma = std::sqrt(scatter / (used - 1) / used);
  }
  return facets;
}

// Gives every pixel of the mask the label that reaches it first.
void grow(Grid<int>& label, const Mask& mask) {
  std::vector<std::pair<int, int>> front, next;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (label(row, col) >= 0) front.push_back({row, col});
    }
  }
  while (!front.empty()) {
    next.clear();
    for (const auto& [row, col] : front) {
      for (const auto& [dr, dc] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
        const int r = row + dr, c = col + dc;
        if (!mask.contains(r, c) || !mask(r, c) || label(r, c) >= 0) continue;
        label(r, c) = label(row, col);
        next.push_back({r, c});
      }
    }
    std::swap(front, next);
  }
}

// Joins facets that are neighbours and hardly differ; returns the new number of each.
std::vector<int> joined(const std::vector<Facet>& facets, const Grid<int>& grown, double least) {
  std::vector<int> root(facets.size());
  for (std::size_t f = 0; f < root.size(); ++f) root[f] = int(f);
  const auto find = [&](int f) {
    while (root[std::size_t(f)] != f) f = root[std::size_t(f)];
    return f;
  };
  for (int row = 0; row < grown.rows(); ++row) {
    for (int col = 0; col < grown.cols(); ++col) {
      for (const auto& [r, c] : {std::pair{row, col + 1}, {row + 1, col}}) {
        if (!grown.contains(r, c)) continue;
        const int a = grown(row, col), b = grown(r, c);
        if (a < 0 || b < 0 || a == b) continue;
        const auto& one = facets[std::size_t(a)].slope;
        if ((one - facets[std::size_t(b)].slope).norm() >= least) continue;
        const int low = std::min(find(a), find(b)), high = std::max(find(a), find(b));
        root[std::size_t(high)] = low;
      }
    }
  }
  std::vector<int> number(facets.size());
  int count = 0;
  for (std::size_t f = 0; f < number.size(); ++f) {
    number[f] = find(int(f)) == int(f) ? count++ : number[std::size_t(find(int(f)))];
  }
  return number;
}

}  // namespace

Facets facets_of(const Surface& surface, const FacetOptions& options) {
  const Mask& mask = surface.mask;
  if (surface.normals.empty()) {
    throw Error("the surface has no normals; reconstruct it from pictures under several lights");
  }
  const Slopes slopes = slopes_of(surface.normals, mask);
  const double least = options.smallest_fold_deg * std::numbers::pi / 180.0;
  // Windows so wide that four of their sigmas stay below half of the smallest fold.
  const double noise = noise_of(slopes, mask);
  const int widest = std::max(3, std::min(mask.rows(), mask.cols()) / 24);
  const int reach = std::clamp(int(std::ceil(0.5 * (8.0 * noise / least - 1.0))), 2, widest);
  const double smooth = noise / (2.0 * reach + 1.0);
  const double allowed = std::max(0.5 * least, 6.0 * smooth);
  const Mask flat = flat_pixels(WindowMeans(slopes, mask, reach), mask, reach, allowed);
  std::vector<int> sizes;
  Facets result;
  result.reach_px = 2 * reach + 1;
  result.label = connected(flat, sizes);
  // Too small to be a facet: specks between creases.
  const int fewest = std::max(64, 4 * result.reach_px * result.reach_px);
  std::vector<int> number(sizes.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] >= fewest) number[i] = count++;
  }
  if (count == 0) {
    throw Error("the surface has no flat part; a creased sheet must lie still and be in focus");
  }
  const auto renumber = [&](const std::vector<int>& numbers) {
    for (int& label : result.label) label = label < 0 ? -1 : numbers[std::size_t(label)];
  };
  renumber(number);
  const int square = 2 * result.reach_px;
  Grid<int> grown = result.label;
  grow(grown, mask);
  const auto together = joined(measured(slopes, result.label, count, square), grown, least);
  renumber(together);
  count = 1 + *std::max_element(together.begin(), together.end());
  result.facets = measured(slopes, result.label, count, square);
  grow(result.label, mask);
  return result;
}

}  // namespace hada
