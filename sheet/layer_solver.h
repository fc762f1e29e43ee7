#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace hada {

/// A yes-or-no variable or its opposite: 2 v or 2 v + 1.
using Literal = int;

/// Conditions on yes-or-no variables, of the three kinds that stacked layers need.
///
/// Equalities are merged as they come, so that what is left is small. Solutions are counted by
/// trying values, following what they force, and counting parts that no longer touch separately; a
/// part that comes up again is remembered.
class LayerSolver {
 public:
  explicit LayerSolver(int variables);

  /// Both have the same value. Each returns false if that contradicts what was said before.
  bool equal(Literal a, Literal b);
  /// Has the value yes.
  bool fix(Literal a);
  /// Not all three have the same value: a over b over c over a would be a circle.
  void not_all_equal(Literal a, Literal b, Literal c) { triples_.push_back({a, b, c}); }
  /// An even number of the four has the value yes.
  void even(Literal a, Literal b, Literal c, Literal d) { fours_.push_back({a, b, c, d}); }

  /// Draws the conclusions that need no trying.
  /// returns  a variable that cannot have any value, if there is one
  std::optional<int> simplify();

  /// After `simplify`: the variables that are left, by parts that do not touch.
  std::vector<std::vector<int>> parts();
  /// How many solutions a part has; `most` if there are as many or more.
  std::uint64_t count(const std::vector<int>& part, std::uint64_t most);
  /// Gives a part its first solution for which `accept` holds.
  bool choose(const std::vector<int>& part);
  /// The value of a variable that is fixed or chosen.
  bool value(int variable) const;

 private:
  struct Rule {
    std::array<Literal, 4> literals;
    int size;  // 3: not all equal, 4: even
  };
  Literal root(Literal a) const;
  bool propagate(std::size_t from);
  bool assign(int variable, int value);
  void undo(std::size_t to);
  int state(Literal a) const { return values_[std::size_t(a / 2)] ^ (a & 1); }  // 2, 3: open
  bool open(Literal a) const { return values_[std::size_t(a / 2)] > 1; }
  bool is_live(const Rule& rule) const;
  std::uint64_t remembered(const std::vector<int>& part, std::uint64_t most);
  /// What is left of a part as a number: equal parts under equal conditions have equal ones.
  std::array<std::uint64_t, 2> signature(std::vector<int> part) const;
  std::vector<std::vector<int>> split(const std::vector<int>& part);
  int busiest(const std::vector<int>& part) const;

  mutable std::vector<Literal> parent_;
  std::vector<std::uint8_t> values_;  // of roots: 0, 1, or 2 while open
  std::vector<std::array<Literal, 3>> triples_;
  std::vector<std::array<Literal, 4>> fours_;
  std::vector<Rule> rules_;
  std::vector<std::vector<int>> rules_of_;
  std::vector<int> trail_;
  std::vector<int> mark_;
  std::map<std::array<std::uint64_t, 2>, std::uint64_t> counted_;  // by signature
  int stamp_ = 0;
  int conflict_ = 0;
};

}  // namespace hada
