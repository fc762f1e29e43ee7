#include "reconstruct/slope_solver.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "core/parallel.h"

namespace hada {
namespace {

using Padded = std::vector<double>;  // laid out as the finest graph

// The sum over all rows of `work(row)`, formed in row order.
template <class Work>
double sum_of_rows(int rows, const Work& work) {
  std::vector<double> sums(std::size_t(rows), 0.0);
  for_each_index(rows, [&](int row) { sums[std::size_t(row)] = work(row); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

// A^T b: what the slopes along the edges ask of every pixel.
Padded right_hand_side(const PixelGraph& graph, const SlopeMap& slopes) {
  Padded right(graph.size(), 0.0);
  for_each_index(graph.rows, [&](int row) {
    // Rise from a pixel to its neighbour on the right, and to the one below; rows run against y.
    const auto rise_east = [&](int col) {
      return 0.5 * (double(slopes(row, col).x()) + slopes(row, col + 1).x());
    };
    const auto rise_south = [&](int upper, int col) {
      return -0.5 * (double(slopes(upper, col).y()) + slopes(upper + 1, col).y());
    };
    const std::size_t first = graph.first(row);
    for (int col = 0; col < graph.cols; ++col) {
      const std::size_t i = first + std::size_t(col);
      double sum = 0.0;
      if (graph.east[i - 1] > 0.0f) sum += rise_east(col - 1);
      if (graph.east[i] > 0.0f) sum -= rise_east(col);
      if (graph.south[i - graph.stride()] > 0.0f) sum += rise_south(row - 1, col);
      if (graph.south[i] > 0.0f) sum -= rise_south(row, col);
      right[i] = sum;
    }
  });
  return right;
}

}  // namespace

SlopeSolver::SlopeSolver(const Mask& mask) : multigrid_(mask), regions_(regions_of(mask)) {}

void SlopeSolver::subtract_region_means(Padded& value) const {
  const PixelGraph& graph = multigrid_.finest();
  std::vector<double> mean(regions_.size.size(), 0.0);
  for (int row = 0; row < graph.rows; ++row) {
    for (int col = 0; col < graph.cols; ++col) {
      const auto region = std::size_t(regions_.label(row, col));
      mean[region] += value[graph.first(row) + std::size_t(col)] / regions_.size[region];
    }
  }
  for_each_index(graph.rows, [&](int row) {
    for (int col = 0; col < graph.cols; ++col) {
      value[graph.first(row) + std::size_t(col)] -= mean[std::size_t(regions_.label(row, col))];
    }
  });
}

Grid<float> SlopeSolver::height(const SlopeMap& slopes, double relative_tolerance,
                                int max_iterations) {
  const PixelGraph& graph = multigrid_.finest();
  const std::size_t cols = std::size_t(graph.cols);
  Padded residual = right_hand_side(graph, slopes);
  Padded height(graph.size(), 0.0);
  Padded direction(graph.size(), 0.0);
  Padded image(graph.size(), 0.0);  // of the direction, under the Laplacian
  double energy = 0.0;              // residual times preconditioned residual
  double first_energy = 0.0;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    std::copy(residual.begin(), residual.end(), multigrid_.right().begin());
    multigrid_.cycle();
    const std::vector<float>& improved = multigrid_.value();
    const double last_energy =
        std::exchange(energy, sum_of_rows(graph.rows, [&](int row) {
                        double sum = 0.0;
                        for (std::size_t i = graph.first(row); i < graph.first(row) + cols; ++i) {
                          sum += residual[i] * improved[i];
                        }
                        return sum;
                      }));
    if (iteration == 0) first_energy = energy;
    if (!(energy > relative_tolerance * relative_tolerance * first_energy)) break;
    const double beta = iteration == 0 ? 0.0 : energy / last_energy;
    for_each_index(graph.rows, [&](int row) {
      for (std::size_t i = graph.first(row); i < graph.first(row) + cols; ++i) {
        direction[i] = improved[i] + beta * direction[i];
      }
    });
    const double curvature = sum_of_rows(graph.rows, [&](int row) {
      double sum = 0.0;
      for (std::size_t i = graph.first(row); i < graph.first(row) + cols; ++i) {
        const double degree = double(graph.east[i]) + graph.east[i - 1] + graph.south[i] +
                              graph.south[i - graph.stride()];
        image[i] = degree * direction[i] - graph.gather(direction, i);
        sum += direction[i] * image[i];
      }
      return sum;
    });
    const double step = energy / curvature;
    for_each_index(graph.rows, [&](int row) {
      for (std::size_t i = graph.first(row); i < graph.first(row) + cols; ++i) {
        height[i] += step * direction[i];
        residual[i] -= step * image[i];
      }
    });
  }
  subtract_region_means(height);
  Grid<float> result(graph.rows, graph.cols);
  for (int row = 0; row < graph.rows; ++row) {
    for (int col = 0; col < graph.cols; ++col) {
      if (regions_.label(row, col) == 0) continue;
      result(row, col) = float(height[graph.first(row) + std::size_t(col)]);
    }
  }
  return result;
}

}  // namespace hada
