#pragma once

#include <filesystem>
#include <string>

namespace hada {

/// The file or folder `name` in `folder`, which must be there.
///
/// name    of parts joined by '/', none of them ".." or hidden; "" is the folder itself
/// throws  Error if it is missing, leads out of the folder, also by a link, or is of another form
std::filesystem::path place_within(const std::filesystem::path& folder, const std::string& name);

/// The text of a file there. throws  Error as above, and if it is no file or larger than 64 MB
std::string text_within(const std::filesystem::path& folder, const std::string& name);

/// A sentence in which the folder's own path is left out: the page knows files by their place in
/// it.
std::string without_folder(const std::filesystem::path& folder, std::string sentence);

}  // namespace hada
