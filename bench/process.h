#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hada {

/// What a run of the program took.
struct ProcessCost {
  int exit_code = 0;
  double seconds = 0.0;
  double megabytes = 0.0;            // of resident memory, at most
  double anonymous_megabytes = 0.0;  // of it backed by no file, at most, looked at every 10 ms
};

/// Runs `program` with its output thrown away, and waits for it.
///
/// most_anonymous_mb  private memory that the system grants it; 0: as much as there is. Mapped
/// files
///                    do not count, for the system can take their memory back
ProcessCost run_process(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, int most_anonymous_mb = 0);

/// Whether two folders hold the same files with the same bytes.
bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace hada
