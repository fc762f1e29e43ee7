#include "reconstruct/sparse_rows.h"

#include <numeric>

namespace hada {

SparseRows transposed(const SparseRows& matrix) {
  SparseRows result(matrix.rows(), matrix.memory());
  result.start.assign(std::size_t(matrix.columns) + 1, 0);
  result.column.resize(matrix.column.size());
  result.weight.resize(matrix.weight.size());
  for (const int column : matrix.column) ++result.start[std::size_t(column) + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  auto next = result.start;
  for (int row = 0; row < matrix.rows(); ++row) {
    const auto columns = matrix.columns_of(row);
    const auto weights = matrix.weights_of(row);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto place = std::size_t(next[std::size_t(columns[i])]++);
      result.column[place] = row;
      result.weight[place] = weights[i];
    }
  }
  return result;
}

}  // namespace hada
