#include "reconstruct/multigrid.h"

#include <algorithm>
#include <functional>

#include "core/parallel.h"

namespace hada {
namespace {

// Rows of a level are shared out only where that is worth the start of a thread.
constexpr std::size_t least_parallel_size = 200000;

void for_rows(const PixelGraph& graph, int rows, const std::function<void(int, int)>& work) {
  if (graph.size() < least_parallel_size) return work(0, rows);
  for_slices(rows, work);
}

PixelGraph coarser(const PixelGraph& fine) {
  PixelGraph coarse((fine.rows + 1) / 2, (fine.cols + 1) / 2);
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      const std::size_t cell = fine.first(row) + std::size_t(col);
      const std::size_t parent = coarse.first(row / 2) + std::size_t(col / 2);
      if (col % 2 == 1) coarse.east[parent] += 0.5f * fine.east[cell];
      if (row % 2 == 1) coarse.south[parent] += 0.5f * fine.south[cell];
    }
  }
  coarse.update_inverse();
  return coarse;
}

// Gauss-Seidel on the cells with (row + col) % 2 == colour; they see only those of the other.
void smooth(const PixelGraph& graph, const std::vector<float>& right, int colour,
            std::vector<float>& value) {
  for_rows(graph, graph.rows, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::size_t last = graph.first(row) + std::size_t(graph.cols);
      for (std::size_t i = graph.first(row) + std::size_t((row + colour) % 2); i < last; i += 2) {
        value[i] = (right[i] + graph.gather(value, i)) * graph.inverse[i];
      }
    }
  });
}

// The first sweep from zero: nothing to gather yet.
void smooth_zero(const PixelGraph& graph, const std::vector<float>& right,
                 std::vector<float>& value) {
  for_rows(graph, graph.rows, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::size_t first = graph.first(row);
      for (std::size_t i = first; i < first + std::size_t(graph.cols); ++i) {
        value[i] = right[i] * graph.inverse[i];
      }
    }
  });
}

// The residual, added up over the cells of each parent.
void restrict_residual(const PixelGraph& fine, const std::vector<float>& value,
                       const std::vector<float>& right, const PixelGraph& coarse,
                       std::vector<float>& coarse_right) {
  for_rows(fine, coarse.rows, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::size_t parent = coarse.first(row);
      std::fill_n(coarse_right.begin() + std::ptrdiff_t(parent), coarse.cols, 0.0f);
      for (int child = 2 * row; child < std::min(2 * row + 2, fine.rows); ++child) {
        const std::size_t first = fine.first(child);
        for (int col = 0; col < fine.cols; ++col) {
          const std::size_t i = first + std::size_t(col);
          if (fine.inverse[i] == 0.0f) continue;
          coarse_right[parent + std::size_t(col / 2)] +=
              right[i] + fine.gather(value, i) - value[i] / fine.inverse[i];
        }
      }
    }
  });
}

void add_coarse(const PixelGraph& coarse, const std::vector<float>& coarse_value,
                const PixelGraph& fine, std::vector<float>& value) {
  for_rows(fine, fine.rows, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const std::size_t first = fine.first(row);
      const std::size_t parent = coarse.first(row / 2);
      for (int col = 0; col < fine.cols; ++col) {
        value[first + std::size_t(col)] += coarse_value[parent + std::size_t(col / 2)];
      }
    }
  });
}

}  // namespace

PixelGraph::PixelGraph(int row_count, int col_count) : rows(row_count), cols(col_count) {
  east.assign(size(), 0.0f);
  south.assign(size(), 0.0f);
  inverse.assign(size(), 0.0f);
}

PixelGraph::PixelGraph(const Mask& mask) : PixelGraph(mask.rows(), mask.cols()) {
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (!mask(row, col)) continue;
      const std::size_t cell = first(row) + std::size_t(col);
      if (col + 1 < cols && mask(row, col + 1)) east[cell] = 1.0f;
      if (row + 1 < rows && mask(row + 1, col)) south[cell] = 1.0f;
    }
  }
  update_inverse();
}

void PixelGraph::update_inverse() {
  for (int row = 0; row < rows; ++row) {
    for (std::size_t i = first(row); i < first(row) + std::size_t(cols); ++i) {
      const float sum = east[i] + east[i - 1] + south[i] + south[i - stride()];
      inverse[i] = sum > 0.0f ? 1.0f / sum : 0.0f;
    }
  }
}

Multigrid::Multigrid(const Mask& mask) {
  PixelGraph graph(mask);
  while (true) {
    const std::size_t size = graph.size();
    levels_.push_back({std::move(graph), std::vector<float>(size), std::vector<float>(size)});
    const PixelGraph& last = levels_.back().graph;
    if (last.rows <= 1 && last.cols <= 1) break;
    graph = coarser(last);
  }
}

void Multigrid::cycle(std::size_t index, bool from_zero) {
  auto& [graph, value, right] = levels_[index];
  constexpr int red = 0;
  constexpr int black = 1;
  if (from_zero) {
    smooth_zero(graph, right, value);
  } else {
    smooth(graph, right, red, value);
  }
  smooth(graph, right, black, value);
  if (index + 1 < levels_.size()) {
    Level& next = levels_[index + 1];
    restrict_residual(graph, value, right, next.graph, next.right);
    cycle(index + 1, true);
    if (index + 2 < levels_.size()) cycle(index + 1, false);
    add_coarse(next.graph, next.value, graph, value);
  }
  smooth(graph, right, black, value);
  smooth(graph, right, red, value);
}

}  // namespace hada
