#pragma once

#include <string_view>

namespace hada {

/// Whether the bytes of a PNG or JPEG file reach its end undamaged; true for any other format.
///
/// The libraries behind OpenImageIO fill what a JPEG lacks with grey, and print about a damaged PNG
/// by themselves. So the frame of both is walked first: chunks and their sums, segments and scans.
///
/// Source: PNG specification (W3C 2003), section 5; JPEG, ITU-T T.81 (1992), annex B.
bool is_whole(std::string_view bytes);

}  // namespace hada
