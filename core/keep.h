#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace hada {

/// Where the values of a grid are kept.
///
/// On disk they lie in a file without a name that is mapped into memory: whoever reads a row gets
/// it as always, and the system may take the memory of other rows away. Such grids need not fit
/// into memory together. The file is in the folder TMPDIR, else in /var/tmp, and is gone with the
/// grid, however the program ends. Where the disk has no room, memory is taken as usual.
enum class Keep { in_memory, on_disk };

/// on_disk for pictures that take more than half a gigabyte together.
Keep keep_of_pictures(std::size_t bytes);

/// throws  std::bad_alloc if neither disk nor memory has room
void* map_on_disk(std::size_t bytes);
void unmap_from_disk(void* memory, std::size_t bytes);

/// Gives back the memory that holds these bytes of a grid on disk. Their values stay: whoever looks
/// at them again fetches them again.
void let_go_of_memory(const void* begin, std::size_t bytes);

/// Allocates where `keep` says; a copy is kept where its original is.
template <class T>
struct KeepAllocator {
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  Keep keep = Keep::in_memory;

  KeepAllocator() = default;
  explicit KeepAllocator(Keep where) : keep(where) {}
  template <class U>
  KeepAllocator(const KeepAllocator<U>& other) : keep(other.keep) {}

  T* allocate(std::size_t count) {
    if (keep == Keep::in_memory) return std::allocator<T>().allocate(count);
    return static_cast<T*>(map_on_disk(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) {
    if (keep == Keep::in_memory) {
      std::allocator<T>().deallocate(memory, count);
    } else {
      unmap_from_disk(memory, count * sizeof(T));
    }
  }
  bool operator==(const KeepAllocator& other) const { return keep == other.keep; }
};

}  // namespace hada
