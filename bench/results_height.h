#pragma once

#include <string>

namespace hada {

/// The section on integration, beside solvers that others wrote, all measured in this run.
std::string height_results();

}  // namespace hada
