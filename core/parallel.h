#pragma once

#include <functional>

namespace hada {

/// How many threads `for_slices` uses; 0 restores the default, the number of cores.
void set_threads(int count);
int threads();

/// Calls `work(begin, end)` on equal, contiguous slices of [0, count), one slice to a thread.
///
/// Calls within a slice share what threads are left: with three of four taken, each has one.
///
/// The slices must not write to common places; a sum is formed per row and added up in row order by
/// the caller, so that the result does not depend on the number of threads. The first exception (in
/// the order of the slices) is thrown again here.
void for_slices(int count, const std::function<void(int begin, int end)>& work);

/// The same, calling `work(i)` for every i in [0, count).
template <class Work>
void for_each_index(int count, const Work& work) {
  for_slices(count, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work(i);
  });
}

}  // namespace hada
