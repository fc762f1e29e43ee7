#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hada {

/// What the names of the files in a folder of photographs say about them.
struct CaptureFolder {
  std::vector<std::string> pictures;             // in natural order
  std::map<std::string, std::string> auxiliary;  // "mask", "ambient", "flat", "dark": its file
  std::vector<std::string> left_out;             // "notes.txt (not an image)"
};

/// Sorts the files of `folder` by their names; hidden files are passed over in silence.
///
/// throws  Error if it is missing or not a folder
CaptureFolder sorted_folder(const std::filesystem::path& folder);

/// Whether a comes before b when runs of digits count as numbers: a2 before a10.
bool natural_less(const std::string& a, const std::string& b);

}  // namespace hada
