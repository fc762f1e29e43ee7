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

}  // namespace hada
