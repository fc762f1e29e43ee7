#include "io/svg_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

// Numbers one after another, with or without commas between.
class Numbers {
 public:
  explicit Numbers(const std::string& text) : text_(text) {}
  std::optional<double> next() {
    skip();
    const char* begin = text_.c_str() + at_;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin) return std::nullopt;
    at_ += std::size_t(end - begin);
    return value;
  }
  /// The letter that stands here, if one does.
  char letter() {
    skip();
    return at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) ? text_[at_++]
                                                                                      : '\0';
  }
  bool ended() {
    skip();
    return at_ >= text_.size();
  }

 private:
  void skip() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
  }
  const std::string& text_;
  std::size_t at_ = 0;
};

// The straight strokes of a path; curves are taken by their ends.
SvgStrokes strokes_of_path(const std::string& data, const std::string& where) {
  SvgStrokes strokes;
  Numbers numbers(data);
  Vector2d at = Vector2d::Zero(), start = at;
  char command = '\0';
  while (!numbers.ended()) {
    if (const char letter = numbers.letter(); letter != '\0')
      command = letter;
    else if (command == 'M')
      command = 'L';  // pairs after a move are lines
    else if (command == 'm')
      command = 'l';
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = char(std::toupper(command));
    if (kind == 'Z') {
      strokes.push_back({at, start});
      at = start;
      command = '\0';
      continue;
    }
    static const std::map<char, int> counts{{'M', 2}, {'L', 2}, {'H', 1}, {'V', 1}, {'C', 6},
                                            {'S', 4}, {'Q', 4}, {'T', 2}, {'A', 7}};
    const auto count = counts.find(kind);
    std::array<double, 7> n{};
    for (int i = 0; count != counts.end() && i < count->second; ++i) {
      const auto value = numbers.next();
      if (!value) throw Error(where + ": a path is broken off; write whole pairs of numbers");
      n[std::size_t(i)] = *value;
    }
    if (count == counts.end()) {
      throw Error(where + ": a path has an unknown command; use M, L, H, V, Z and curves");
    }
    Vector2d to = relative ? at : Vector2d::Zero();
    if (kind == 'H') to = {to.x() + n[0], at.y()};
    if (kind == 'V') to = {at.x(), to.y() + n[0]};
    if (kind != 'H' && kind != 'V') {
      const std::size_t last = std::size_t(count->second) - 2;
      to += Vector2d(n[last], n[last + 1]);
    }
    if (kind == 'M') start = to;
    if (kind != 'M') strokes.push_back({at, to});
    at = to;
  }
  return strokes;
}

}  // namespace

std::optional<SvgTag> next_tag(const std::string& text, std::size_t& at, const std::string& where) {
  for (at = text.find('<', at); at != std::string::npos; at = text.find('<', at)) {
    const bool comment = text.compare(at, 4, "<!--") == 0;
    if (!comment && text[at + 1] != '!' && text[at + 1] != '?') break;
    at = text.find(comment ? "-->" : ">", at);
    if (at == std::string::npos) return std::nullopt;
  }
  if (at == std::string::npos) return std::nullopt;
  ++at;
  const auto skip_space = [&] {
    while (at < text.size() && is_space(text[at])) ++at;
  };
  const auto word = [&] {
    std::string name;
    while (at < text.size() && !is_space(text[at]) && text[at] != '>' && text[at] != '=' &&
           !(text[at] == '/' && !name.empty())) {
      name += text[at++];
    }
    return name;
  };
  SvgTag tag;
  tag.name = lower(word());
  if (tag.name.starts_with('/')) {
    tag.closes = true;
    tag.name.erase(0, 1);
  }
  for (skip_space(); at < text.size() && text[at] != '>'; skip_space()) {
    if (text[at] == '/') {
      tag.alone = true;
      ++at;
      continue;
    }
    const std::string key = lower(word());
    skip_space();
    if (at >= text.size() || text[at] != '=') {
      if (key.empty()) break;
      continue;
    }
    ++at;
    skip_space();
    if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) break;
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string::npos) break;
    tag.attributes[key] = text.substr(at + 1, end - at - 1);
    at = end + 1;
  }
  if (at >= text.size() || text[at] != '>') {
    throw Error(where + ": the tag <" + tag.name + "> is broken off; fetch the file again");
  }
  return tag;
}

SvgAttributes declarations(const std::string& text) {
  SvgAttributes found;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::size_t colon = text.find(':', at);
    if (colon < end) {
      const auto trimmed = [&](std::size_t from, std::size_t to) {
        while (from < to && is_space(text[from])) ++from;
        while (from < to && is_space(text[to - 1])) --to;
        return text.substr(from, to - from);
      };
      found[lower(trimmed(at, colon))] = trimmed(colon + 1, end);
    }
    at = end + 1;
  }
  return found;
}

std::map<std::string, SvgAttributes> rules_of(const std::string& sheet) {
  std::map<std::string, SvgAttributes> rules;
  for (std::size_t open = sheet.find('{'); open != std::string::npos;) {
    const std::size_t close = std::min(sheet.find('}', open), sheet.size());
    const SvgAttributes body = declarations(sheet.substr(open + 1, close - open - 1));
    std::size_t at = open == 0 ? 0 : sheet.rfind('}', open) + 1;  // 0 where there is none
    for (; at < open; ++at) {
      if (sheet[at] != '.') continue;
      const std::size_t end = sheet.find_first_of(" ,{\n\r\t", at);
      for (const auto& [key, value] : body) rules[sheet.substr(at + 1, end - at - 1)][key] = value;
    }
    open = sheet.find('{', close);
  }
  return rules;
}

std::optional<std::array<int, 3>> colour_of(const std::string& text) {
  static const std::map<std::string, std::array<int, 3>> names{
      {"red", {255, 0, 0}},       {"blue", {0, 0, 255}},     {"black", {0, 0, 0}},
      {"yellow", {255, 255, 0}},  {"lime", {0, 255, 0}},     {"green", {0, 128, 0}},
      {"magenta", {255, 0, 255}}, {"fuchsia", {255, 0, 255}}};
  const std::string name = lower(text);
  if (const auto known = names.find(name); known != names.end()) return known->second;
  std::array<int, 3> rgb{};
  if (name.starts_with("#") && (name.size() == 7 || name.size() == 4)) {
    const bool brief = name.size() == 4;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string digits = brief ? std::string(2, name[1 + i]) : name.substr(1 + 2 * i, 2);
      if (!std::isxdigit(digits[0]) || !std::isxdigit(digits[1])) return std::nullopt;
      rgb[i] = int(std::strtol(digits.c_str(), nullptr, 16));
    }
    return rgb;
  }
  if (name.starts_with("rgb(")) {
    const std::string inside = name.substr(4);
    Numbers numbers(inside);
    for (int& part : rgb) part = int(std::clamp(numbers.next().value_or(0.0), 0.0, 255.0));
    return rgb;
  }
  return std::nullopt;
}

Eigen::Affine2d transform_of(const std::string& text) {
  Eigen::Affine2d whole = Eigen::Affine2d::Identity();
  for (std::size_t at = 0, open; (open = text.find('(', at)) != std::string::npos;) {
    const std::size_t close = std::min(text.find(')', open), text.size());
    std::string kind = text.substr(at, open - at);
    std::erase_if(kind, [](char c) { return is_space(c) || c == ','; });
    const std::string inside = text.substr(open + 1, close - open - 1);
    Numbers numbers(inside);
    std::vector<double> n;
    while (const auto value = numbers.next()) n.push_back(*value);
    const auto at_or = [&](std::size_t i, double other) { return i < n.size() ? n[i] : other; };
    if (kind == "translate") whole.translate(Vector2d(at_or(0, 0), at_or(1, 0)));
    if (kind == "scale") whole.scale(Vector2d(at_or(0, 1), at_or(1, at_or(0, 1))));
    if (kind == "rotate") {
      const Vector2d centre(at_or(1, 0), at_or(2, 0));
      whole.translate(centre);
      whole.rotate(at_or(0, 0) * M_PI / 180.0);
      whole.translate(-centre);
    }
    if (kind == "matrix" && n.size() == 6) {
      Eigen::Affine2d step = Eigen::Affine2d::Identity();
      step.matrix().topRows<2>() << n[0], n[2], n[4], n[1], n[3], n[5];
      whole = whole * step;
    }
    at = close + 1;
  }
  return whole;
}

SvgStrokes strokes_of(const SvgTag& tag, const std::string& where) {
  const auto number = [&](const char* key) {
    const auto found = tag.attributes.find(key);
    return found == tag.attributes.end() ? 0.0 : std::strtod(found->second.c_str(), nullptr);
  };
  const auto text = [&](const char* key) {
    const auto found = tag.attributes.find(key);
    return found == tag.attributes.end() ? std::string() : found->second;
  };
  if (tag.name == "line") {
    return {{Vector2d(number("x1"), number("y1")), Vector2d(number("x2"), number("y2"))}};
  }
  if (tag.name == "path") return strokes_of_path(text("d"), where);
  std::vector<Vector2d> corners;
  if (tag.name == "rect") {
    const double x = number("x"), y = number("y"), w = number("width"), h = number("height");
    corners = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
  }
  if (tag.name == "polyline" || tag.name == "polygon") {
    const std::string points = text("points");
    Numbers numbers(points);
    while (const auto x = numbers.next()) {
      const auto y = numbers.next();
      if (!y) throw Error(where + ": a polygon is broken off; write whole pairs of numbers");
      corners.emplace_back(*x, *y);
    }
  }
  SvgStrokes strokes;
  const bool closed = tag.name != "polyline";
  for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
    strokes.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  return strokes;
}

}  // namespace hada
