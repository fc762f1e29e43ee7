#pragma once

#include <string>

#include "app/comparison.h"

namespace hada {

/// Two surfaces side by side at the same scale, with the same colours and the same light, their
/// difference and their rings: one page of HTML that needs nothing else.
std::string compare_page(const Surface& first, const Surface& second, const Comparison& comparison);

}  // namespace hada
