#pragma once

#include <string>

namespace hada {

/// The section of the page of results on forged steel.
std::string forged_results();

}  // namespace hada
