#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

/// The field table of a material is the single source of its parameter names, units and bounds.
///
/// A material is `template <class T> struct M` with a `name`, members of type T and a constexpr
/// `fields()` that returns an array of Field. Where it owns more, constexpr functions say so:
/// `parts()` a tuple of PartList, `lists()` a tuple of NumberList, `words()` an array of Word. A
/// part is such a struct too, without a name. Packing for a solver, the JSON keys, `hada
/// materials`, the docs page and the contract tests walk these.
namespace hada {

/// How a solver sees a field.
enum class Scale {
  linear,     // as it is, between its bounds
  log,        // by its logarithm, between its bounds; a value of 0 packs as 1e-20 of the high bound
  half_turn,  // a direction modulo pi: free in the solver, wrapped into [0, pi) by `wrapped`
};

template <class Owner, class T>
struct Field {
  std::string_view name;
  T Owner::*member;
  double low;   // the smallest value that is meaningful
  double high;  // the largest
  Scale scale;
  std::string_view unit;     // "mm", "rad", "mm^4"; empty for a plain number
  std::string_view meaning;  // a few words for a person
  bool optional = false;     // whether a file may leave it out, which means 0
};

/// Whether files and tables do not name a field: it is optional and says nothing.
template <class AnyField>
constexpr bool is_left_out(const AnyField& field, double value) {
  if constexpr (requires { field.optional; }) return field.optional && value == 0.0;
  return false;
}

template <class Owner, class Part>
struct PartList {
  std::string_view name;
  std::vector<Part> Owner::*member;
  int fewest;
  int most;
  bool optional = false;  // whether a file leaves it out where there are none
};

/// Numbers that all mean the same: the radii of rings, the two coordinates of a point.
template <class Owner, class T>
struct NumberList {
  std::string_view name;
  std::vector<T> Owner::*member;
  int fewest;
  int most;
  double low;  // of every number, as in Field
  double high;
  Scale scale;
  std::string_view unit;
  std::string_view meaning;
};

/// What is chosen, not measured: a sequence of folds. No solver moves it and it has no sigma.
template <class Owner>
struct Word {
  std::string_view name;
  std::string Owner::*member;
  bool (*is_valid)(std::string_view text);
  std::string_view rule;  // completes "must be ...", for whoever writes another
  std::string_view meaning;
};

template <class M>
concept HasParts = requires {
  M::parts();
};

template <class M>
concept HasLists = requires {
  M::lists();
};

template <class M>
concept HasWords = requires {
  M::words();
};

/// Calls `visit(word, text)` for every word of the material itself.
template <class M, class Visit>
void visit_words(M& material, const Visit& visit) {
  using Plain = std::remove_const_t<M>;
  if constexpr (HasWords<Plain>) {
    for (const auto& word : Plain::words()) visit(word, material.*(word.member));
  }
}

/// Calls `visit(path, field, value)` for every number: parts in order, then lists, then fields.
///
/// `path` is like "components[1].long_mm" or "radii_mm[3]", `field` the Field or the NumberList,
/// `value` a reference into `material` (const if that is).
template <class M, class Visit>
void visit_fields(M& material, const Visit& visit, const std::string& prefix = "") {
  using Plain = std::remove_const_t<M>;
  if constexpr (HasParts<Plain>) {
    const auto visit_list = [&](const auto& list) {
      auto& parts = material.*(list.member);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        visit_fields(parts[i], visit,
                     prefix + std::string(list.name) + "[" + std::to_string(i) + "].");
      }
    };
    std::apply([&](const auto&... lists) { (visit_list(lists), ...); }, Plain::parts());
  }
  if constexpr (HasLists<Plain>) {
    const auto visit_list = [&](const auto& list) {
      auto& values = material.*(list.member);
      for (std::size_t i = 0; i < values.size(); ++i) {
        visit(prefix + std::string(list.name) + "[" + std::to_string(i) + "]", list, values[i]);
      }
    };
    std::apply([&](const auto&... lists) { (visit_list(lists), ...); }, Plain::lists());
  }
  for (const auto& field : Plain::fields()) {
    visit(prefix + std::string(field.name), field, material.*(field.member));
  }
}

/// A material over another scalar: its lists as long as those of `shape`, its words the same, its
/// numbers the defaults.
template <class U, template <class> class M>
M<U> shaped_like(const M<double>& shape) {
  M<U> result;
  const auto size_alike = [&](const auto& to, const auto& from) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((result.*(std::get<I>(to).member)).resize((shape.*(std::get<I>(from).member)).size()), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<std::decay_t<decltype(from)>>>{});
  };
  if constexpr (HasParts<M<double>>) size_alike(M<U>::parts(), M<double>::parts());
  if constexpr (HasLists<M<double>>) size_alike(M<U>::lists(), M<double>::lists());
  if constexpr (HasWords<M<double>>) {
    const auto to = M<U>::words();
    const auto from = M<double>::words();
    for (std::size_t i = 0; i < to.size(); ++i) result.*(to[i].member) = shape.*(from[i].member);
  }
  return result;
}

/// Where the solver's copy of a field may lie; infinite for a half turn.
struct SolverBounds {
  double low;
  double high;
};

/// field  a Field or a NumberList
template <class F>
double log_low(const F& field) {
  return std::log(std::max(field.low, 1e-20 * field.high));
}

template <class F>
SolverBounds solver_bounds(const F& field) {
  if (field.scale == Scale::log) return {log_low(field), std::log(field.high)};
  if (field.scale == Scale::half_turn) return {-HUGE_VAL, HUGE_VAL};
  return {field.low, field.high};
}

/// The fields as the solver sees them, in the order of `visit_fields`.
template <class M>
std::vector<double> pack(const M& material) {
  std::vector<double> packed;
  visit_fields(material, [&](const std::string&, const auto& field, const double& value) {
    packed.push_back(field.scale == Scale::log
                         ? std::max(std::log(std::max(value, 1e-300)), log_low(field))
                         : value);
  });
  return packed;
}

/// The material whose `pack` is `packed`, with the lists of `shape`. U is double or a Jet.
template <class U, template <class> class M>
M<U> unpack(const M<double>& shape, const U* packed) {
  using std::exp;
  M<U> material = shaped_like<U>(shape);
  visit_fields(material, [&](const std::string&, const auto& field, U& value) {
    value = field.scale == Scale::log ? exp(*packed) : *packed;
    ++packed;
  });
  return material;
}

/// Bounds of every packed field, in the order of `pack`.
template <class M>
std::vector<SolverBounds> solver_bounds_of(const M& material) {
  std::vector<SolverBounds> bounds;
  visit_fields(material, [&](const std::string&, const auto& field, const double&) {
    bounds.push_back(solver_bounds(field));
  });
  return bounds;
}

/// `angle` modulo pi, in [0, pi).
inline double half_turn(double angle) {
  const double rest = std::fmod(angle, std::numbers::pi);
  const double wrapped = rest < 0.0 ? rest + std::numbers::pi : rest;
  return wrapped < std::numbers::pi ? wrapped : 0.0;
}

/// The same material with every half-turn field wrapped into [0, pi).
template <class M>
M wrapped(M material) {
  visit_fields(material, [](const std::string&, const auto& field, double& value) {
    if (field.scale == Scale::half_turn) value = half_turn(value);
  });
  return material;
}

}  // namespace hada
