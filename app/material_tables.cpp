#include "app/material_tables.h"

#include "app/material_file.h"
#include "app/material_list.h"
#include "io/json.h"

namespace hada {
namespace {

std::string_view name_of(Scale scale) {
  switch (scale) {
    case Scale::linear:
      return "linear";
    case Scale::log:
      return "log";
    case Scale::half_turn:
      return "half turn";
  }
  return "";
}

template <class F>
Json field_json(const F& field) {
  return {{"name", field.name}, {"low", field.low},
          {"high", field.high}, {"scale", name_of(field.scale)},
          {"unit", field.unit}, {"meaning", field.meaning}};
}

template <class M>
Json fields_json() {
  Json fields = Json::array();
  for (const auto& field : M::fields()) fields.push_back(field_json(field));
  return fields;
}

// "lists" are parts, each of several fields, or numbers, each of one.
template <class M>
Json material_json() {
  Json json = {{"name", M::name}, {"summary", M::summary}, {"fields", fields_json<M>()}};
  json["defaults"] = json_of(M{});
  json["lists"] = Json::array();
  const auto add = [&](const auto& list, Json fields) {
    json["lists"].push_back({{"name", list.name},
                             {"fewest", list.fewest},
                             {"most", list.most},
                             {"fields", std::move(fields)}});
  };
  const auto add_parts = [&]<class Part>(const PartList<M, Part>& list) {
    add(list, fields_json<Part>());
    json["lists"].back()["part"] = json_of(Part{});  // one as it begins
  };
  if constexpr (HasParts<M>) {
    std::apply([&](const auto&... lists) { (add_parts(lists), ...); }, M::parts());
  }
  if constexpr (HasLists<M>) {
    std::apply([&](const auto&... lists) { (add(lists, Json::array({field_json(lists)})), ...); },
               M::lists());
  }
  json["words"] = Json::array();
  if constexpr (HasWords<M>) {
    for (const auto& word : M::words()) {
      json["words"].push_back(
          {{"name", word.name}, {"rule", word.rule}, {"meaning", word.meaning}});
    }
  }
  return json;
}

}  // namespace

std::string material_tables_text(const std::string& only) {
  if (!only.empty()) material_named(only);
  Json all = Json::array();
  for_each_material([&](const auto& m) {
    using M = std::decay_t<decltype(m)>;
    if (only.empty() || only == M::name) all.push_back(material_json<M>());
  });
  return Json{{"hada", "materials/1"}, {"materials", all}}.dump(1);
}

}  // namespace hada
