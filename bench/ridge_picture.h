#pragma once

#include <filesystem>

namespace hada {

/// Writes a picture: a made sheet with ridges, one drawn from its fitted spectrum alone and one
/// with the fitted ridges, 60 mm wide, and 20 mm of each below; all in the same colours.
void write_ridges_picture(const std::filesystem::path& path);

}  // namespace hada
