#pragma once

#include <filesystem>
#include <string>

namespace hada {

/// The section of the page of results on wood. data: where real data lies, if it does.
std::string wood_results(const std::filesystem::path& data);

}  // namespace hada
