#include "bench/results_page.h"

#include <fmt/format.h>

namespace hada {
namespace {

// What stands in a page from a title up to the next; "" if the title is not there.
std::string section_of(const std::string& page, const std::string& title_line) {
  const auto begin = page.find("\n" + title_line + "\n");
  if (begin == std::string::npos) return "";
  const auto end = page.find("\n## ", begin + 1);
  return page.substr(begin, end == std::string::npos ? std::string::npos : end - begin);
}

}  // namespace

std::string table(const std::string& title, const std::string& heads) {
  std::string rule = "|";
  for (const char c : heads) {
    if (c == '|') rule += " --- |";
  }
  rule.resize(rule.size() - 6);  // one more bar than columns
  return "\n## " + title + "\n\n" + heads + "\n" + rule + "\n";
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string verdict(bool met) {
  return met ? "met" : "**not met**";
}

std::string judged(double value, const Asked& asked, const char* form) {
  const std::string number = fmt::format(fmt::runtime(form), value);
  const char* reached = value <= asked.goal ? "goal" : value <= asked.must ? "met" : "**not met**";
  return fmt::format("{} ({} / {}: {})", number, asked.must, asked.goal, reached);
}

std::string with_sections(std::string page, const std::string& fresh) {
  for (auto at = fresh.find("\n## "); at != std::string::npos; at = fresh.find("\n## ", at + 1)) {
    const std::string title = fresh.substr(at + 1, fresh.find('\n', at + 1) - at - 1);
    const std::string next = section_of(fresh, title);
    const std::string last = section_of(page, title);
    if (last.empty()) {
      page += next;
    } else {
      page.replace(page.find(last), last.size(), next);
    }
  }
  return page;
}

}  // namespace hada
