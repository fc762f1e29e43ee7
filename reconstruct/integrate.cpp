#include "reconstruct/integrate.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "core/error.h"
#include "reconstruct/slope_solver.h"

namespace hada {
namespace {

void require_pixels(const Mask& mask) {
  if (std::none_of(mask.begin(), mask.end(), [](auto inside) { return inside != 0; })) {
    throw Error("the mask is empty: there is no pixel to find a height for; check the mask");
  }
}

// One equation (row of A, entry of b) for every pair of neighbours, in pixels.
struct Equations {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd rise;
};

Equations equations_of(const NormalMap& normals, const Mask& mask, const Grid<int>& unknown,
                       int unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> rises;
  const auto add = [&](int row, int col, int other_row, int other_col, double rise) {
    const int equation = int(rises.size());
    entries.emplace_back(equation, unknown(other_row, other_col), 1.0);
    entries.emplace_back(equation, unknown(row, col), -1.0);
    rises.push_back(rise);
  };
  const auto slope = [&](int row, int col, int axis) {
    const Eigen::Vector3d normal = normals(row, col).cast<double>();
    return -normal[axis] / normal.z();
  };
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      if (mask.contains(row, col + 1) && mask(row, col + 1)) {
        add(row, col, row, col + 1, 0.5 * (slope(row, col, 0) + slope(row, col + 1, 0)));
      }
      if (mask.contains(row + 1, col) && mask(row + 1, col)) {
        add(row, col, row + 1, col, -0.5 * (slope(row, col, 1) + slope(row + 1, col, 1)));
      }
    }
  }
  Equations equations{Eigen::SparseMatrix<double>(int(rises.size()), unknowns),
                      Eigen::Map<Eigen::VectorXd>(rises.data(), Eigen::Index(rises.size()))};
  equations.matrix.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

// A region without its mean; which pixels make a region is read off the matrix itself.
void subtract_region_means(const Eigen::SparseMatrix<double>& laplacian, Eigen::VectorXd& height) {
  std::vector<char> seen(std::size_t(height.size()), 0);
  for (int start = 0; start < height.size(); ++start) {
    if (seen[std::size_t(start)]) continue;
    std::vector<int> region{start};
    seen[std::size_t(start)] = 1;
    double sum = 0.0;
    for (std::size_t next = 0; next < region.size(); ++next) {
      sum += height[region[next]];
      for (Eigen::SparseMatrix<double>::InnerIterator entry(laplacian, region[next]); entry;
           ++entry) {
        if (seen[std::size_t(entry.row())]) continue;
        seen[std::size_t(entry.row())] = 1;
        region.push_back(int(entry.row()));
      }
    }
    for (const int pixel : region) height[pixel] -= sum / double(region.size());
  }
}

}  // namespace

Grid<float> integrate(const NormalMap& normals, const Mask& mask, double pitch,
                      const IntegrateOptions& options) {
  assert(normals.same_size(mask) && pitch > 0.0);
  require_pixels(mask);
  const SlopeMap slopes = slopes_of(normals, mask, options.pin_hole);
  Grid<float> height =
      SlopeSolver(mask).height(slopes, options.relative_tolerance, options.max_iterations);
  for (float& value : height) value = float(value * pitch);
  if (options.pin_hole) height_from_log_depth(height, options.pin_hole->focal_px.x() * pitch);
  return height;
}

Grid<double> integrate_reference(const NormalMap& normals, const Mask& mask, double pitch,
                                 double relative_tolerance) {
  require_pixels(mask);
  Grid<int> unknown(mask.rows(), mask.cols(), -1);
  int unknowns = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) unknown[i] = unknowns++;
  }
  const Equations equations = equations_of(normals, mask, unknown, unknowns);
  const Eigen::SparseMatrix<double> laplacian = equations.matrix.transpose() * equations.matrix;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                           Eigen::IdentityPreconditioner>
      solver(laplacian);
  solver.setTolerance(relative_tolerance);
  solver.setMaxIterations(10 * unknowns + 100);
  Eigen::VectorXd height = solver.solve(equations.matrix.transpose() * equations.rise);
  subtract_region_means(laplacian, height);
  Grid<double> result(mask.rows(), mask.cols(), 0.0);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) result[i] = pitch * height[unknown[i]];
  }
  return result;
}

}  // namespace hada
