#pragma once

#include <cstddef>
#include <memory_resource>

namespace hada {

/// Memory for pictures that need not fit into it together: every array is a file without a name
/// that is mapped, so that whoever reads a row gets it as always while the system may take the
/// memory of other rows away.
///
/// The files are in the folder TMPDIR, else in /var/tmp, and are gone with their arrays, however
/// the program ends. Where the disk has no room, memory is taken as usual.
std::pmr::memory_resource* scratch_files();

/// `scratch_files()` for pictures that take more than half a gigabyte together, else the heap.
std::pmr::memory_resource* memory_for_pictures(std::size_t bytes);

/// Gives back the memory that holds these bytes of an array in `scratch_files()`. Their values
/// stay: whoever looks at them again fetches them again.
void let_go_of_memory(const void* begin, std::size_t bytes);

}  // namespace hada
