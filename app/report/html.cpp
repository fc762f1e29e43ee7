#include "app/report/html.h"

#include <cstdint>

#include <fmt/format.h>

#include "io/image_file.h"

namespace hada {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ink: #1d2129; --soft: #5d6675; --line: #d5d9e0; --ground: #fff;
  --data: #1f5fa8; --model: #c4540a; --third: #2b8a5b; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e7ec; --soft: #9aa4b4; --line: #3a414d;
  --ground: #15181d; --data: #74b0f0; --model: #f0955a; --third: #6fcf9f; } }
@media print { :root { color-scheme: light; --ink: #000; --soft: #444; --line: #bbb; --ground: #fff;
  --data: #1f5fa8; --model: #c4540a; --third: #2b8a5b; }
  figure, table, table { width: auto; } .row > table { align-self: start; }
.row { break-inside: avoid; } h2 { break-after: avoid; } }
body { background: var(--ground); color: var(--ink); margin: 0 auto; padding: 2rem 1.2rem 4rem;
  max-width: 60rem; font: 16px/1.55 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .5rem; padding-top: .9rem;
  border-top: 1px solid var(--line); }
p { max-width: 44rem; margin: .6rem 0; }
ul { max-width: 44rem; padding-left: 1.2rem; }
.lead { font-size: 1.08rem; }
figure { margin: .8rem 0; min-width: 0; }
figcaption { color: var(--soft); font-size: .87rem; line-height: 1.4; margin-top: .3rem; }
figure svg, figure img { display: block; width: 100%; height: auto; }
svg { font: 12px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
svg text { fill: currentColor; }
svg text.soft { fill: var(--soft); }
table { width: auto; } .row > table { align-self: start; }
.row { display: grid; gap: 0 1.4rem; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); }
.strip { display: grid; gap: .5rem; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); }
.strip figure { margin: 0; }
table { border-collapse: collapse; margin: .8rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .9rem .22rem 0; text-align: right; border-bottom: 1px solid var(--line); }
td { white-space: nowrap; }
th { font-weight: 600; color: var(--soft); font-size: .87rem; }
th:first-child, td:first-child { text-align: left; }
th:last-child, td:last-child { text-align: left; white-space: normal; color: var(--soft); }
footer { margin-top: 3rem; color: var(--soft); font-size: .85rem; }
)";

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? std::uint32_t(bytes[i + k]) : 0u;
    };
    const std::uint32_t triple = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_padding = k > bytes.size() - i;
      text += is_padding ? '=' : digits[triple >> (18 - 6 * k) & 63u];
    }
  }
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string data_address(const Image& picture) {
  return "data:image/png;base64," + base64(encode_png(picture));
}

std::string table(const std::vector<std::string>& head, const std::vector<TableRow>& rows) {
  std::string html = "<table><thead><tr>";
  for (const auto& title : head) html += "<th>" + title + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const auto& cell : row.cells) html += "<td>" + cell + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string paragraph(const std::string& html) {
  return "<p>" + html + "</p>\n";
}

std::string bullets(const std::vector<std::string>& sentences) {
  std::string html = "<ul>\n";
  for (const auto& sentence : sentences) html += "<li>" + escaped(sentence) + "</li>\n";
  return html + "</ul>\n";
}

std::string side_by_side(const std::vector<std::string>& blocks) {
  std::string html = "<div class=\"row\">\n";
  for (const auto& block : blocks) html += block;
  return html + "</div>\n";
}

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n"
      "</html>\n",
      escaped(title), style, body);
}

}  // namespace hada
