#include "io/json.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

namespace hada {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t(64) << 20;
constexpr int deepest = 64;

// Follows the parser and refuses what it would let pass: a key given twice, endless nesting.
class Watch {
 public:
  explicit Watch(std::string where) : where_(std::move(where)) {}

  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > deepest) throw Error(where_ + ": is nested too deep; write it flatter");
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key && !keys_.back().insert(parsed).second) {
      throw Error(where_ + ": the key " + parsed.dump() + " is given twice; keep one of them");
    }
    return true;
  }

 private:
  std::string where_;
  std::vector<std::set<std::string>> keys_;
};

std::string line_and_column(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + std::ptrdiff_t(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto line_start = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return "line " + std::to_string(line) + ", column " +
         std::to_string(std::max<std::ptrdiff_t>(1, end - line_start));
}

std::string quoted(const std::string& key) {
  return Json(key).dump();
}

}  // namespace

Json parsed_json(const std::string& text, const std::string& where) {
  try {
    Watch watch(where);
    return Json::parse(text, [&](int depth, Json::parse_event_t event, Json& value) {
      return watch(depth, event, value);
    });
  } catch (const Json::parse_error& error) {
    throw Error(where + ": is not valid JSON at " + line_and_column(text, error.byte) +
                "; correct it there");
  } catch (const Json::exception&) {
    throw Error(where + ": holds a number that is too large; write a finite one");
  }
}

std::string text_of_file(const fs::path& path) {
  std::error_code problem;
  if (!fs::exists(path, problem)) throw Error(path.string() + ": no such file; check the name");
  if (!fs::is_regular_file(path, problem)) {
    throw Error(path.string() + ": is not a file; name a file");
  }
  if (fs::file_size(path, problem) > most_bytes) {
    throw Error(path.string() + ": is larger than 64 MB; this cannot be one of our files");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream) throw Error(path.string() + ": cannot be read; check its rights");
  return text;
}

Json read_plain_json(const fs::path& path) {
  return parsed_json(text_of_file(path), path.string());
}

Json read_json(const fs::path& path, const std::string& kind) {
  return json_of_kind(text_of_file(path), path.string(), kind);
}

Json json_of_kind(const std::string& text, const std::string& where, const std::string& kind) {
  Json json = parsed_json(text, where);
  const auto stated = json.is_object() ? json.find("hada") : json.end();
  if (!json.is_object() || stated == json.end() || !stated->is_string()) {
    throw Error(where + ": does not say what it is; begin it with \"hada\": " + quoted(kind));
  }
  if (*stated != kind) {
    throw Error(where + ": is a file of kind " + stated->dump() + "; one of kind " + quoted(kind) +
                " is needed");
  }
  json.erase("hada");
  return json;
}

JsonObject::JsonObject(const Json& json, std::string where)
    : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) throw Error(where_ + ": must be an object in braces { }");
}

bool JsonObject::has(const std::string& key) {
  asked_.insert(key);
  return json_.contains(key);
}

bool JsonObject::is_list(const std::string& key) {
  return has(key) && json_.at(key).is_array();
}

const Json& JsonObject::at(const std::string& key) {
  if (!has(key)) fail(key, "is missing; add it");
  return json_.find(key).value();
}

double JsonObject::number(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_number()) fail(key, "must be a number");
  const double number = value.get<double>();
  if (!std::isfinite(number)) fail(key, "must be a finite number");
  return number;
}

double JsonObject::number(const std::string& key, double otherwise) {
  return has(key) ? number(key) : otherwise;
}

int JsonObject::integer(const std::string& key) {
  const double value = number(key);
  constexpr double most = std::numeric_limits<int>::max();
  if (value != std::floor(value) || std::abs(value) > most) fail(key, "must be a whole number");
  return int(value);
}

std::string JsonObject::text(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_string()) fail(key, "must be a text in quotes");
  return value.get<std::string>();
}

std::string JsonObject::text(const std::string& key, const std::string& otherwise) {
  return has(key) ? text(key) : otherwise;
}

bool JsonObject::flag(const std::string& key, bool otherwise) {
  if (!has(key)) return otherwise;
  const Json& value = at(key);
  if (!value.is_boolean()) fail(key, "must be true or false");
  return value.get<bool>();
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t count) {
  const Json& value = list(key);
  const auto is_finite = [](const Json& entry) {
    return entry.is_number() && std::isfinite(entry.get<double>());
  };
  if (value.size() != count || !std::all_of(value.begin(), value.end(), is_finite)) {
    fail(key, "must be a list of " + std::to_string(count) + " finite numbers");
  }
  return value.get<std::vector<double>>();
}

const Json& JsonObject::list(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_array()) fail(key, "must be a list in brackets [ ]");
  return value;
}

JsonObject JsonObject::object(const std::string& key) {
  const Json& value = at(key);
  const bool at_top = where_.find(": ") == std::string::npos;
  return JsonObject(value, where_ + (at_top ? ": " : ".") + key);
}

void JsonObject::finish() const {
  for (const auto& [key, value] : json_.items()) {
    if (asked_.contains(key)) continue;
    std::string known;
    for (const auto& name : asked_) known += (known.empty() ? "" : ", ") + name;
    fail(key, "is not a known key; known are " + known);
  }
}

void JsonObject::fail(const std::string& key, const std::string& what) const {
  throw Error(where_ + ": " + quoted(key) + " " + what);
}

std::string bounds_text(double low, double high) {
  return Json(low).dump() + " and " + Json(high).dump();
}

}  // namespace hada
