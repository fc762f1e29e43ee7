#include "reconstruct/weighted_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/sum_of_rows.h"

namespace hada {
namespace {

// What cycles leave shrinks unevenly: a rate below this is not believed to last.
constexpr double least_rate = 0.05;

double dot(const Grid<double>& a, const Grid<double>& b) {
  return sum_of_rows(a.rows(), [&](int row) {
    return std::inner_product(a.row(row).begin(), a.row(row).end(), b.row(row).begin(), 0.0);
  });
}

// x = factor x + y, or x += factor y.
void scale_and_add(double factor, Grid<double>& x, const Grid<double>& y) {
  for_each_index(x.rows(), [&](int row) {
    for (int col = 0; col < x.cols(); ++col) x(row, col) = factor * x(row, col) + y(row, col);
  });
}
void add_times(double factor, const Grid<double>& y, Grid<double>& x) {
  for_each_index(x.rows(), [&](int row) {
    for (int col = 0; col < x.cols(); ++col) x(row, col) += factor * y(row, col);
  });
}

}  // namespace

// work(row, col, weight) for the pixels that a pixel of the mask is joined to.
template <class Work>
void WeightedSolver::for_neighbours(int row, int col, const Work& work) const {
  const auto& [east, south] = weights_;
  const auto inside = [&](int r, int c) { return mask_.contains(r, c) && mask_(r, c); };
  if (inside(row - 1, col)) work(row - 1, col, double(south(row - 1, col)));
  if (inside(row, col - 1)) work(row, col - 1, double(east(row, col - 1)));
  if (inside(row, col + 1)) work(row, col + 1, double(east(row, col)));
  if (inside(row + 1, col)) work(row + 1, col, double(south(row, col)));
}

// The sum of all edges at a pixel.
double WeightedSolver::held(int row, int col) const {
  double sum = 0.0;
  for_neighbours(row, col, [&](int, int, double weight) { sum += weight; });
  return sum;
}

WeightedSolver::WeightedSolver(const Mask& mask, EdgeWeights weights)
    : mask_(mask),
      weights_(std::move(weights)),
      index_(mask.rows(), mask.cols(), -1, mask.memory()),
      black_([&] {
        int count = 0;
        for (int row = 0; row < mask.rows(); ++row) {
          for (int col = 0; col < mask.cols(); ++col) {
            if (!mask(row, col)) continue;
            pixels_ += 1.0;
            if (is_black(row, col)) index_(row, col) = count++;
          }
        }
        return graph_of_black();
      }()) {}

// Two black pixels are joined through the red ones between them, in series.
SparseRows WeightedSolver::graph_of_black() const {
  SparseRows graph(0, mask_.memory());
  std::vector<std::pair<int, double>> edges;
  for (int row = 0; row < mask_.rows(); ++row) {
    for (int col = 0; col < mask_.cols(); ++col) {
      const int here = index_(row, col);
      if (here < 0) continue;
      edges.clear();
      for_neighbours(row, col, [&](int r, int c, double to_red) {
        const double sum = held(r, c);
        for_neighbours(r, c, [&](int rr, int cc, double weight) {
          if (weight > 0.0 && index_(rr, cc) != here) {
            edges.emplace_back(index_(rr, cc), to_red / sum * weight);
          }
        });
      });
      std::stable_sort(edges.begin(), edges.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (auto edge = edges.begin(); edge != edges.end();) {
        double sum = 0.0;
        const int to = edge->first;
        for (; edge != edges.end() && edge->first == to; ++edge) sum += edge->second;
        if (sum > 0.0) graph.add(to, float(sum));
      }
      graph.end_row();
    }
  }
  graph.columns = graph.rows();
  return graph;
}

// A^T W (b - A z): how the rises that are missing pull at every pixel.
void WeightedSolver::find_residual(const EdgeRises& rises, const Grid<double>& height,
                                   Grid<double>& residual) const {
  for_each_index(mask_.rows(), [&](int row) {
    for (int col = 0; col < mask_.cols(); ++col) {
      if (!mask_(row, col)) continue;
      double sum = 0.0;
      for_neighbours(row, col, [&](int r, int c, double weight) {
        const double rise = r < row   ? rises.south(r, c)
                            : c < col ? rises.east(r, c)
                            : c > col ? -double(rises.east(row, col))
                                      : -double(rises.south(row, col));
        sum += weight * (rise + (height(r, c) - height(row, col)));
      });
      residual(row, col) = sum;
    }
  });
}

// About A^-1 residual, up to a constant in each region.
void WeightedSolver::precondition(const Grid<double>& residual, Grid<double>& step) {
  const auto share = [&](int row, int col, double weight) {
    return weight > 0.0 ? weight / held(row, col) : 0.0;
  };
  for_each_index(mask_.rows(), [&](int row) {
    for (int col = 0; col < mask_.cols(); ++col) {
      if (index_(row, col) < 0) continue;
      double sum = residual(row, col);
      for_neighbours(row, col, [&](int r, int c, double weight) {
        sum += share(r, c, weight) * residual(r, c);
      });
      black_.right()[std::size_t(index_(row, col))] = sum;
    }
  });
  const AlgebraicMultigrid::Values& value = black_.cycle();
  for_each_index(mask_.rows(), [&](int row) {
    for (int col = 0; col < mask_.cols(); ++col) {
      if (!mask_(row, col)) continue;
      if (is_black(row, col)) {
        step(row, col) = value[std::size_t(index_(row, col))];
        continue;
      }
      double sum = residual(row, col);
      double weights = 0.0;
      for_neighbours(row, col, [&](int r, int c, double weight) {
        sum += weight * value[std::size_t(index_(r, c))];
        weights += weight;
      });
      step(row, col) = weights > 0.0 ? sum / weights : 0.0;
    }
  });
}

// step^T A step
double WeightedSolver::energy(const Grid<double>& step) const {
  return sum_of_rows(mask_.rows(), [&](int row) {
    double sum = 0.0;
    for (int col = 0; col < mask_.cols(); ++col) {
      if (!mask_(row, col)) continue;
      for_neighbours(row, col, [&](int r, int c, double weight) {
        if (r > row || c > col) sum += weight * std::pow(step(r, c) - step(row, col), 2);
      });
    }
    return sum;
  });
}

WeightedSolver::Solution WeightedSolver::solve(const EdgeRises& rises, double tolerance,
                                               int max_cycles, const CycleDone& done) {
  Solution solution{Grid<double>(mask_.rows(), mask_.cols(), 0.0, mask_.memory())};
  Grid<double> residual = solution.height;
  Grid<double> step = solution.height;
  Grid<double> direction = solution.height;
  double last_agreement = 0.0;
  double last_size = 0.0;
  while (solution.cycles < max_cycles) {
    find_residual(rises, solution.height, residual);
    precondition(residual, step);
    const double agreement = dot(residual, step);
    scale_and_add(last_agreement > 0.0 ? agreement / last_agreement : 0.0, direction, step);
    last_agreement = agreement;
    const double length = agreement / energy(direction);
    ++solution.cycles;
    if (!std::isfinite(agreement)) {
      throw Error("the slopes or the weights of the map are too large to add up: check them");
    }
    if (!(agreement > 0.0) || !std::isfinite(length)) break;
    add_times(length, direction, solution.height);
    const double size = length * std::sqrt(dot(direction, direction) / pixels_);
    const double rate = last_size > 0.0 ? std::clamp(size / last_size, least_rate, 0.9) : 0.9;
    const double error = size * rate / (1.0 - rate);  // what all further steps would add
    last_size = size;
    if (done) done(solution.cycles, error);
    if (error < tolerance) break;
  }
  return solution;
}

}  // namespace hada
