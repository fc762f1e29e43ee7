#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/field.h"

/// The only header that includes the JSON library; included by sources alone.
namespace hada {

using Json = nlohmann::ordered_json;

/// The object in a JSON file that begins with `"hada": kind`, e.g. kind "lights/1", without that
/// key.
///
/// Stricter than the format: a key given twice, nesting beyond 64 levels or 64 MB are Errors too.
/// throws  Error naming the file if it is missing, is not JSON, or is of another kind or schema
Json read_json(const std::filesystem::path& path, const std::string& kind);

/// The same of a text that came another way; `where` names it in errors.
Json json_of_kind(const std::string& text, const std::string& where, const std::string& kind);

/// Any JSON text; as strict about its form.
Json parsed_json(const std::string& text, const std::string& where);

/// The JSON file of another program, whatever it holds; as strict about its form.
Json read_plain_json(const std::filesystem::path& path);

/// The text of a file of words, at most 64 MB.
/// throws  Error naming the file if it is missing, a folder, larger or unreadable
std::string text_of_file(const std::filesystem::path& path);

/// One object of a file that is being read: every key must be asked for, and every number finite.
///
/// where  "lights.json: lights[2]": how errors name the place
class JsonObject {
 public:
  JsonObject(const Json& json, std::string where);

  bool has(const std::string& key);
  bool is_list(const std::string& key);
  /// throws  Error naming the place and the key if it is missing, of another type or not finite
  double number(const std::string& key);
  double number(const std::string& key, double otherwise);
  int integer(const std::string& key);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  bool flag(const std::string& key, bool otherwise);
  std::vector<double> numbers(const std::string& key, std::size_t count);
  const Json& list(const std::string& key);
  JsonObject object(const std::string& key);
  const std::string& where() const { return where_; }
  /// throws  Error naming the first key that nobody asked for, and those that are known
  void finish() const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  const Json& at(const std::string& key);
  const Json& json_;
  std::string where_;
  std::set<std::string> asked_;
};

/// The numbers and words of a material (or the numbers of its sigma) under the names of its tables;
/// what is optional and 0 is left out.
template <class M>
Json json_of(const M& material) {
  Json json = Json::object();
  visit_words(material, [&](const auto& word, const std::string& text) {
    json[std::string(word.name)] = text;
  });
  if constexpr (HasParts<M>) {
    const auto add_list = [&](const auto& list) {
      Json parts = Json::array();
      if (list.optional && (material.*(list.member)).empty()) return;
      for (const auto& part : material.*(list.member)) parts.push_back(json_of(part));
      json[std::string(list.name)] = std::move(parts);
    };
    std::apply([&](const auto&... lists) { (add_list(lists), ...); }, M::parts());
  }
  if constexpr (HasLists<M>) {
    const auto add_list = [&](const auto& list) {
      json[std::string(list.name)] = material.*(list.member);
    };
    std::apply([&](const auto&... lists) { (add_list(lists), ...); }, M::lists());
  }
  for (const auto& field : M::fields()) {
    const double value = material.*(field.member);
    if (!is_left_out(field, value)) json[std::string(field.name)] = value;
  }
  return json;
}

/// How an Error says which numbers are taken.
std::string bounds_text(double low, double high);

/// `object`'s value of a field; a half turn takes any finite angle and is wrapped.
template <class F>
double value_within(const F& field, double value, const JsonObject& object,
                    const std::string& path) {
  if (field.scale == Scale::half_turn) return half_turn(value);
  if (value < field.low || value > field.high) {
    object.fail(path, "must lie between " + bounds_text(field.low, field.high));
  }
  return value;
}

/// The inverse of `json_of`. Unknown keys, values outside their bounds and missing keys of fields
/// that are not optional are Errors.
template <class M>
M material_from(JsonObject object) {
  M material;
  const auto check_count = [&](const auto& list, std::size_t count) {
    if (int(count) < list.fewest || int(count) > list.most) {
      object.fail(std::string(list.name), "takes " + std::to_string(list.fewest) + " to " +
                                              std::to_string(list.most) + " entries");
    }
  };
  visit_words(material, [&](const auto& word, std::string& text) {
    text = object.text(std::string(word.name));
    if (!word.is_valid(text)) {
      object.fail(std::string(word.name), "must be " + std::string(word.rule));
    }
  });
  if constexpr (HasParts<M>) {
    const auto read_list = [&](const auto& list) {
      auto& parts = material.*(list.member);
      const std::string key(list.name);
      parts.clear();
      if (list.optional && !object.has(key)) return;
      const Json& json = object.list(key);
      check_count(list, json.size());
      using Part = typename std::remove_reference_t<decltype(parts)>::value_type;
      for (std::size_t i = 0; i < json.size(); ++i) {
        parts.push_back(material_from<Part>(
            JsonObject(json[i], object.where() + "." + key + "[" + std::to_string(i) + "]")));
      }
    };
    std::apply([&](const auto&... lists) { (read_list(lists), ...); }, M::parts());
  }
  if constexpr (HasLists<M>) {
    const auto read_list = [&](const auto& list) {
      auto& values = material.*(list.member);
      const std::string key(list.name);
      const std::size_t count = object.list(key).size();
      check_count(list, count);
      values = object.numbers(key, count);
      for (std::size_t i = 0; i < count; ++i) {
        values[i] = value_within(list, values[i], object, key + "[" + std::to_string(i) + "]");
      }
    };
    std::apply([&](const auto&... lists) { (read_list(lists), ...); }, M::lists());
  }
  for (const auto& field : M::fields()) {
    const std::string key(field.name);
    double& value = material.*(field.member);
    value = value_within(field, field.optional ? object.number(key, value) : object.number(key),
                         object, key);
  }
  object.finish();
  return material;
}

}  // namespace hada
