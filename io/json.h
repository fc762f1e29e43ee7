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

/// The fields of a material (or of its sigma) under the names of its field table.
template <class M>
Json json_of(const M& material) {
  Json json = Json::object();
  if constexpr (HasParts<M>) {
    const auto add_list = [&](const auto& list) {
      Json parts = Json::array();
      for (const auto& part : material.*(list.member)) parts.push_back(json_of(part));
      json[std::string(list.name)] = std::move(parts);
    };
    std::apply([&](const auto&... lists) { (add_list(lists), ...); }, M::parts());
  }
  for (const auto& field : M::fields()) json[std::string(field.name)] = material.*(field.member);
  return json;
}

/// The inverse of `json_of`. Unknown or missing keys and values outside their bounds are Errors.
/// A half-turn field takes any finite angle and is wrapped.
template <class M>
M material_from(JsonObject object) {
  M material;
  if constexpr (HasParts<M>) {
    const auto read_list = [&](const auto& list) {
      auto& parts = material.*(list.member);
      const std::string key(list.name);
      const Json& json = object.list(key);
      if (int(json.size()) < list.fewest || int(json.size()) > list.most) {
        object.fail(key, "takes " + std::to_string(list.fewest) + " to " +
                             std::to_string(list.most) + " entries");
      }
      parts.clear();
      using Part = typename std::remove_reference_t<decltype(parts)>::value_type;
      for (std::size_t i = 0; i < json.size(); ++i) {
        parts.push_back(material_from<Part>(
            JsonObject(json[i], object.where() + "." + key + "[" + std::to_string(i) + "]")));
      }
    };
    std::apply([&](const auto&... lists) { (read_list(lists), ...); }, M::parts());
  }
  for (const auto& field : M::fields()) {
    const double value = object.number(std::string(field.name));
    if (field.scale != Scale::half_turn && (value < field.low || value > field.high)) {
      object.fail(std::string(field.name),
                  "must lie between " + Json(field.low).dump() + " and " + Json(field.high).dump());
    }
    material.*(field.member) = field.scale == Scale::half_turn ? half_turn(value) : value;
  }
  object.finish();
  return material;
}

}  // namespace hada
