#pragma once

#include <string>

#include "app/whole_path.h"

namespace hada {

/// The report on a capture: one page of HTML that needs nothing else. It reads from top to bottom
/// like a letter: what was measured, what was found, how sure that is, and what to do if it is not
/// good enough.
std::string report_html(const WholePath& path);

}  // namespace hada
