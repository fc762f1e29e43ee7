#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hada {

/// What a run of the program took.
struct ProcessCost {
  int exit_code = 0;
  double seconds = 0.0;
  double megabytes = 0.0;  // of resident memory, at most
};

/// Runs `program` with its output thrown away, and waits for it.
ProcessCost run_process(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments);

/// Whether two folders hold the same files with the same bytes.
bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace hada
