#pragma once

#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace hada {

/// The sum over all rows of `work(row)`, formed in row order whatever the number of threads.
template <class Work>
double sum_of_rows(int rows, const Work& work) {
  std::vector<double> sums(std::size_t(rows), 0.0);
  for_each_index(rows, [&](int row) { sums[std::size_t(row)] = work(row); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace hada
