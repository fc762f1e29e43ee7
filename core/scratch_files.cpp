#include "core/scratch_files.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace hada {
namespace {

// A file of this size without a name, or -1. Its room is reserved: a disk that is full must say so
// here, for a page that finds no room later ends the program.
int nameless_file(const char* folder, std::size_t bytes) {
  std::string name = std::string(folder) + "/hada-XXXXXX";
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return -1;
  unlink(name.c_str());
  if (posix_fallocate(file, 0, off_t(bytes)) == 0) return file;
  close(file);
  return -1;
}

int scratch_file(std::size_t bytes) {
  const char* const chosen = std::getenv("TMPDIR");
  if (chosen && *chosen) return nameless_file(chosen, bytes);
  return nameless_file("/var/tmp", bytes);  // unlike /tmp never held in memory
}

class ScratchFiles : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t) override {
    const std::size_t length = bytes > 0 ? bytes : 1;  // nothing at all cannot be mapped
    const int file = scratch_file(length);
    const int flags = file < 0 ? MAP_SHARED | MAP_ANONYMOUS : MAP_SHARED;
    void* const memory = mmap(nullptr, length, PROT_READ | PROT_WRITE, flags, file, 0);
    if (file >= 0) close(file);  // the mapping holds it
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return memory;
  }
  void do_deallocate(void* memory, std::size_t bytes, std::size_t) override {
    munmap(memory, bytes > 0 ? bytes : 1);
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }
};

}  // namespace

std::pmr::memory_resource* scratch_files() {
  static ScratchFiles files;
  return &files;
}

std::pmr::memory_resource* memory_for_pictures(std::size_t bytes) {
  constexpr std::size_t most_on_heap = std::size_t(1) << 29;
  return bytes > most_on_heap ? scratch_files() : nullptr;
}

void let_go_of_memory(const void* begin, std::size_t bytes) {
  if (bytes == 0) return;
  static const auto page = std::uintptr_t(sysconf(_SC_PAGESIZE));
  const auto from = reinterpret_cast<std::uintptr_t>(begin) / page * page;
  const auto length = reinterpret_cast<std::uintptr_t>(begin) + bytes - from;
  // Of a shared mapping this takes the pages from the program only: the file keeps what they hold.
  madvise(reinterpret_cast<void*>(from), length, MADV_DONTNEED);
}

}  // namespace hada
