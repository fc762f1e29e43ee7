#pragma once

#include <string>

namespace hada {

/// How well ridges over wrinkles are found and how sure, as sections of the page of results.
std::string ridge_results();

}  // namespace hada
