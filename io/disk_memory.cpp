#include "io/disk_memory.h"

#include <cstdlib>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/error.h"

namespace hada {
namespace {

constexpr std::size_t least_bytes = std::size_t(1) << 20;  // below, a file is not worth its pages

class FileHandle {
 public:
  explicit FileHandle(int handle) : handle_(handle) {}
  ~FileHandle() {
    if (handle_ >= 0) close(handle_);
  }
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;
  int get() const { return handle_; }

 private:
  int handle_;
};

// Some file systems know no files without a name: there it has one for a moment.
int open_nameless(const std::filesystem::path& folder) {
  const int handle = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (handle >= 0) return handle;
  std::string pattern = (folder / ".hada-scratch-XXXXXX").string();
  const int named = mkostemp(pattern.data(), O_CLOEXEC);
  if (named >= 0) unlink(pattern.c_str());
  return named;
}

}  // namespace

void* DiskMemory::do_allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes < least_bytes) return ::operator new(bytes, std::align_val_t(alignment));
  const FileHandle file(open_nameless(folder_));
  // The room is asked for now: a disk that fills up later would end the program without a word.
  if (file.get() < 0 || posix_fallocate(file.get(), 0, off_t(bytes)) != 0) {
    throw Error(folder_.string() + ": has no room for another " +
                std::to_string((bytes >> 20) + 1) +
                " MB of a map that is larger than the memory; free some, or name another folder");
  }
  void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.get(), 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  madvise(memory, bytes, MADV_SEQUENTIAL);  // advice: where it is not taken nothing is lost
  return memory;
}

void DiskMemory::do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) {
  if (bytes < least_bytes) {
    ::operator delete(memory, std::align_val_t(alignment));
  } else {
    munmap(memory, bytes);
  }
}

}  // namespace hada
