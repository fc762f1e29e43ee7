#pragma once

#include <span>
#include <string_view>

namespace hada {

/// A file of the page, as it was built into the program.
struct PageFile {
  std::string_view name;  // "fold/view.js"
  std::string_view bytes;
};

/// All files of the page; none where the program was built without node.
std::span<const PageFile> page_files();

/// By the ending of its name.
std::string_view type_of(std::string_view name);

}  // namespace hada
