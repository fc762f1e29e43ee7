#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/image.h"

/// The few words of HTML that a report needs. Everything is inline: a page refers to nothing.
namespace hada {

/// Text that may hold <, >, & and quotes, made safe.
std::string escaped(std::string_view text);

/// An 8-bit PNG of the picture as a `data:` address.
std::string data_address(const Image& picture);

struct TableRow {
  std::vector<std::string> cells;  // already HTML
};

/// A table whose first column is text and whose other columns are numbers.
std::string table(const std::vector<std::string>& head, const std::vector<TableRow>& rows);

std::string paragraph(const std::string& html);
std::string bullets(const std::vector<std::string>& sentences);

/// Blocks side by side as long as the page is wide enough.
std::string side_by_side(const std::vector<std::string>& blocks);

/// A whole page: `body` under `title`, readable on a light and on a dark screen and on paper.
std::string page(const std::string& title, const std::string& body);

}  // namespace hada
