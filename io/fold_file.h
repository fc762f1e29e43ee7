#pragma once

#include <filesystem>
#include <string>

#include "core/fold.h"

namespace hada {

/// A FOLD file (1.0 to 1.2): all frames, inherited keys filled in, keys of others passed over.
///
/// throws  Error naming the file and the place if it is no JSON, a list has the wrong length or
///         type, an index points nowhere, a number is not finite, or frames inherit in a circle
///
/// Source: Demaine, Ku, Lang, A new file standard to represent folded structures (FOLD), 2016.
FoldFile read_fold(const std::filesystem::path& path);

/// The text of a FOLD 1.2 file. The first frame is the key frame, the others `file_frames`.
///
/// Assignments, fold angles and face orders appear where the frame has them; faces must be there.
std::string fold_text(const FoldFile& file);

/// A crease pattern in any known format, by the ending of its name: FOLD (its key frame), or lines
/// that are not yet split where they cross: `.cp` and `.opx` (ORIPA), `.svg` (colours of Origami
/// Simulator).
///
/// throws  Error as the readers do, and for other endings
FoldFile read_crease_pattern(const std::filesystem::path& path);

}  // namespace hada
