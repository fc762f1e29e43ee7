#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace hada {

/// The value that `share` of `values` (not empty) lie below; 0 the smallest, 1 the largest.
template <class T>
T quantile(std::vector<T> values, double share) {
  assert(!values.empty());
  const auto last = std::ptrdiff_t(values.size()) - 1;
  const auto nth = values.begin() + std::min(last, std::ptrdiff_t(share * double(values.size())));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// The middle one of `values` (not empty), the upper of two.
template <class T>
T median(std::vector<T> values) {
  return quantile(std::move(values), 0.5);
}

}  // namespace hada
