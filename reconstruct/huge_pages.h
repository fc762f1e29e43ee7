#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace hada {

/// Memory for arrays of many megabytes, asked for in pages of 2 MB where the system has them: a
/// fresh array is touched a thousand times less often for the first time, which takes longer than a
/// cycle of the solver does.
template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t(2) << 20;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < 2 * page) return static_cast<T*>(::operator new(bytes));
    void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (!memory) throw std::bad_alloc();
    madvise(memory, bytes, MADV_HUGEPAGE);  // advice: where it is not taken nothing is lost
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < 2 * page) {
      ::operator delete(memory);
    } else {
      std::free(memory);
    }
  }
  bool operator==(const HugePages&) const { return true; }
};

using Floats = std::vector<float, HugePages<float>>;

}  // namespace hada
