#pragma once

#include <filesystem>
#include <string>

namespace hada {

/// The section of the page of results on knit; figures of pictures that are absent are left out.
std::string knit_results(const std::filesystem::path& data);

}  // namespace hada
