#pragma once

#include <filesystem>
#include <string>

namespace hada {

/// The section of the page of results on the studio.
///
/// figures  JSON that tests/studio/browser/figures.mjs has written: what only a browser knows
std::string studio_results(const std::filesystem::path& figures);

}  // namespace hada
