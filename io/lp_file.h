#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/light_stack.h"

namespace hada {

/// The lights of an RTI light-position file (`.lp`), as domes, RTIBuilder and Relight exchange
/// them: a line with their count, then for each picture `name x y z`, x right, y up, z to the
/// camera.
///
/// The last three words of a line are numbers, what stands before them is the name: it may have
/// spaces, and folders, which are left out. Positions of any length count as directions. Windows
/// line ends, blank lines and a byte order mark are passed over.
///
/// returns  strengths of 1: the format knows none; directions as given, unit length
/// throws   Error naming the file and the line if the count is missing or wrong, a line is not of
///          this form, a direction is not finite or has no length, or no light stands above z = 0
std::vector<Light> read_lp(const std::filesystem::path& path);

/// The text of such a file. Only names and directions are kept.
std::string lp_text(const std::vector<Light>& lights);

/// Whether the name of a file ends in `.lp`, in small or capital letters.
bool is_lp(const std::filesystem::path& path);

}  // namespace hada
