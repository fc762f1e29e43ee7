#pragma once

#include <filesystem>
#include <string>

#include "sheet/sheet.h"

namespace hada {

/// The sheet of a crease pattern in any format: its first flat frame, and where that file also has
/// a folded form of the same vertices, that as its present shape. A folded form alone is unfolded.
///
/// title  receives the title of the file, if given
Sheet read_sheet(const std::filesystem::path& path, std::string* title = nullptr);

}  // namespace hada
