#pragma once

#include <string>

namespace hada {

/// The section of folded paper of the page of results.
std::string fold_results();

}  // namespace hada
