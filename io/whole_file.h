#pragma once

#include <string_view>

namespace hada {

/// Whether the bytes of a PNG or JPEG file reach its end undamaged, and those of a TIFF its first
/// directory; true for any other format.
///
/// The libraries behind OpenImageIO fill what a JPEG lacks with grey, print about a damaged PNG by
/// themselves, and do not know a TIFF without directory for one. So the frame is walked first:
/// chunks and their sums, segments and scans.
///
/// Source: PNG specification (W3C 2003), section 5; JPEG, ITU-T T.81 (1992), annex B; TIFF 6.0
/// (Adobe 1992), section 2.
bool is_whole(std::string_view bytes);

}  // namespace hada
