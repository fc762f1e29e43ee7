#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory_resource>
#include <new>
#include <type_traits>

#include <sys/mman.h>

namespace hada {

/// Where a large array lies: the heap, or what a memory resource hands out, such as a file for maps
/// that are larger than the memory (`io/disk_memory.h`). Copies lie where their source does.
///
/// On the heap, arrays of many megabytes are asked for in pages of 2 MB where the system has them:
/// a fresh array is touched a thousand times less often for the first time, which takes longer than
/// a cycle of the integration does.
template <class T>
struct Memory {
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  using is_always_equal = std::false_type;
  static constexpr std::size_t page = std::size_t(2) << 20;

  std::pmr::memory_resource* resource = nullptr;  // the heap; else it outlives every array in it

  Memory() = default;
  Memory(std::pmr::memory_resource* where) : resource(where) {}
  template <class U>
  Memory(const Memory<U>& other) : resource(other.resource) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (resource) return static_cast<T*>(resource->allocate(bytes, alignof(T)));
    if (bytes < 2 * page) return static_cast<T*>(::operator new(bytes));
    void* const memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
    if (!memory) throw std::bad_alloc();
    madvise(memory, bytes, MADV_HUGEPAGE);  // advice: where it is not taken nothing is lost
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (resource) {
      resource->deallocate(memory, bytes, alignof(T));
    } else if (bytes < 2 * page) {
      ::operator delete(memory);
    } else {
      std::free(memory);
    }
  }
  bool operator==(const Memory& other) const { return resource == other.resource; }
};

}  // namespace hada
