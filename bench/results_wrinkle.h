#pragma once

#include <string>

namespace hada {

/// The sections of the page of results that are about wrinkles: fits, speed, papers, bands.
std::string wrinkle_results();

}  // namespace hada
