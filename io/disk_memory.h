#pragma once

#include <filesystem>
#include <memory_resource>

namespace hada {

/// Memory on the disk, for arrays larger than the memory of the machine: each large one is a file
/// without a name in `folder`, mapped, so that the system writes out what is not in use and reads
/// it back. It pays where arrays are read and written along their length.
///
/// The files vanish with the arrays, and with the program however that ends.
class DiskMemory : public std::pmr::memory_resource {
 public:
  explicit DiskMemory(std::filesystem::path folder) : folder_(std::move(folder)) {}

 private:
  /// throws  Error naming the folder if it does not have the room
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::filesystem::path folder_;
};

}  // namespace hada
