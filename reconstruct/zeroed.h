#pragma once

#include <cstdint>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include <sys/mman.h>

#include "core/memory.h"

namespace hada {

/// `Memory` that is 0 from the start: `Cells(count, where)` touches nothing. The system clears the
/// pages of large arrays when they are first written to, by the threads that do so; clearing them
/// is a sixth of the time that a height takes, and need not be done a second time, nor by one
/// thread.
///
/// Only what is fresh is 0: an array that was made smaller and grows again is not.
template <class T>
struct Zeroed : Memory<T> {
  using Memory<T>::Memory;
  Zeroed() = default;

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (this->resource || bytes < 2 * this->page) {
      T* const memory = Memory<T>::allocate(count);
      std::memset(static_cast<void*>(memory), 0, bytes);
      return memory;
    }
    // A page more than is needed, so that there is a place to start at a whole one.
    const std::size_t whole = mapped(bytes);
    void* const memory = mmap(nullptr, whole + this->page, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    char* const first = static_cast<char*>(memory);
    const std::size_t before = (this->page - reinterpret_cast<std::uintptr_t>(first) % this->page);
    munmap(first, before);
    if (before < this->page) munmap(first + before + whole, this->page - before);
    madvise(first + before, whole, MADV_HUGEPAGE);
    return reinterpret_cast<T*>(first + before);
  }
  void deallocate(T* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (this->resource || bytes < 2 * this->page) {
      Memory<T>::deallocate(memory, count);
    } else {
      munmap(memory, mapped(bytes));
    }
  }

  template <class U>
  void construct(U*) {}
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }

 private:
  static constexpr std::size_t mapped(std::size_t bytes) {
    return (bytes + Memory<T>::page - 1) / Memory<T>::page * Memory<T>::page;
  }
};

using Cells = std::vector<float, Zeroed<float>>;

}  // namespace hada
