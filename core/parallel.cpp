#include "core/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace hada {
namespace {

int chosen_threads = 0;
thread_local int share = 0;  // of the threads, within a slice; 0 outside

}  // namespace

void set_threads(int count) {
  chosen_threads = std::max(count, 0);
}

int threads() {
  if (chosen_threads > 0) return chosen_threads;
  return std::max(1, int(std::thread::hardware_concurrency()));
}

void for_slices(int count, const std::function<void(int, int)>& work) {
  const int most = share > 0 ? share : threads();
  const int slices = std::min(most, count);
  if (slices <= 1) {
    if (count > 0) work(0, count);
    return;
  }
  const auto edge = [&](int slice) { return int(std::int64_t(count) * slice / slices); };
  std::vector<std::exception_ptr> failures(std::size_t(slices), nullptr);
  const auto run = [&](int slice) {
    const int own = std::exchange(share, most / slices);
    try {
      work(edge(slice), edge(slice + 1));
    } catch (...) {
      failures[std::size_t(slice)] = std::current_exception();
    }
    share = own;
  };
  std::vector<std::jthread> helpers;
  for (int slice = 1; slice < slices; ++slice) helpers.emplace_back(run, slice);
  run(0);
  helpers.clear();  // joins
  for (const auto& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace hada
