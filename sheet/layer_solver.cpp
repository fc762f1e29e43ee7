#include "sheet/layer_solver.h"

#include <algorithm>
#include <numeric>

namespace hada {
namespace {

constexpr std::uint8_t is_open = 2;

}  // namespace

LayerSolver::LayerSolver(int variables)
    : parent_(std::size_t(variables)), values_(std::size_t(variables), is_open) {
  for (int v = 0; v < variables; ++v) parent_[std::size_t(v)] = 2 * v;
}

Literal LayerSolver::root(Literal a) const {
  Literal at = a;
  while (parent_[std::size_t(at / 2)] != (at & ~1)) at = parent_[std::size_t(at / 2)] ^ (at & 1);
  // The way up is shortened for the next time.
  for (Literal step = a; step != at;) {
    Literal& up = parent_[std::size_t(step / 2)];
    const Literal next = up ^ (step & 1);
    up = at ^ (step & 1);
    step = next;
  }
  return at;
}

bool LayerSolver::equal(Literal a, Literal b) {
  a = root(a);
  b = root(b);
  if (a == b) return true;
  conflict_ = a / 2;
  if (a / 2 == b / 2) return false;
  if (!open(a)) std::swap(a, b);
  if (!open(a)) return state(a) == state(b);
  parent_[std::size_t(a / 2)] = b ^ (a & 1);
  return true;
}

bool LayerSolver::fix(Literal a) {
  a = root(a);
  conflict_ = a / 2;
  if (!open(a)) return state(a) == 1;
  values_[std::size_t(a / 2)] = std::uint8_t(1 ^ (a & 1));
  return true;
}

std::optional<int> LayerSolver::simplify() {
  // A literal that is fixed is replaced by "yes" or "no": a variable beyond all others.
  const Literal yes = 2 * int(parent_.size());
  parent_.push_back(yes);
  values_.push_back(1);
  const auto reduced = [&](Literal a) {
    a = root(a);
    return open(a) ? a : yes ^ (state(a) == 1 ? 0 : 1);
  };
  const auto settle = [&](Literal a, Literal b) {  // a = b, where either may be yes or no
    if (a == b) return true;
    if (a / 2 == b / 2) return false;
    if (b / 2 == yes / 2) std::swap(a, b);
    return a / 2 == yes / 2 ? fix(b ^ (a & 1)) : equal(a, b);
  };
  for (bool changed = true; changed;) {
    changed = false;
    std::size_t kept = 0;
    for (auto& triple : triples_) {
      auto [a, b, c] = triple;
      a = reduced(a), b = reduced(b), c = reduced(c);
      if (a == (b ^ 1) || a == (c ^ 1) || b == (c ^ 1)) continue;
      if (a == b || a == c || b == c) {
        const Literal same = a == b || a == c ? a : b, third = a == b ? c : a == c ? b : a;
        if (!settle(same, third ^ 1)) return conflict_;
        changed = true;
        continue;
      }
      triple = {a, b, c};
      if (a > b) std::swap(triple[0], triple[1]);
      if (triple[1] > triple[2]) std::swap(triple[1], triple[2]);
      if (triple[0] > triple[1]) std::swap(triple[0], triple[1]);
      triples_[kept++] = triple;
    }
    triples_.resize(kept);
    kept = 0;
    for (auto& four : fours_) {
      for (Literal& a : four) a = reduced(a);
      std::sort(four.begin(), four.end());
      // Equal neighbours cancel; opposite ones count as one yes.
      std::array<Literal, 4> left{};
      int count = 0, odd = 0;
      for (const Literal a : four) {
        odd ^= a & 1;
        if (count > 0 && left[std::size_t(count - 1)] == (a & ~1))
          --count;
        else
          left[std::size_t(count++)] = a & ~1;
      }
      if (count > 0 && left[std::size_t(count - 1)] == yes) --count, odd ^= 1;
      if (count > 2) {
        // Three open literals and a fixed one: kept as four with "yes" as the last.
        four = {left[0] ^ odd, left[1], left[2], count == 4 ? left[3] : yes ^ 1};
        fours_[kept++] = four;
        continue;
      }
      changed = changed || count > 0;
      if (count == 0 && odd != 0) return conflict_;
      if (count == 1 && !fix(left[0] ^ odd ^ 1)) return conflict_;
      if (count == 2 && !equal(left[0], left[1] ^ odd)) return conflict_;
    }
    fours_.resize(kept);
  }
  std::sort(triples_.begin(), triples_.end());
  triples_.erase(std::unique(triples_.begin(), triples_.end()), triples_.end());
  rules_of_.resize(values_.size());
  mark_.assign(values_.size(), 0);
  const auto add = [&](Rule rule) {
    for (int i = 0; i < rule.size; ++i) {
      rules_of_[std::size_t(rule.literals[std::size_t(i)] / 2)].push_back(int(rules_.size()));
    }
    rules_.push_back(rule);
  };
  for (const auto& [a, b, c] : triples_) add({{a, b, c, 0}, 3});
  for (const auto& four : fours_) add({four, 4});
  return std::nullopt;
}

bool LayerSolver::assign(int variable, int value) {
  values_[std::size_t(variable)] = std::uint8_t(value);
  trail_.push_back(variable);
  return propagate(trail_.size() - 1);
}

bool LayerSolver::propagate(std::size_t from) {
  for (; from < trail_.size(); ++from) {
    for (const int r : rules_of_[std::size_t(trail_[from])]) {
      const Rule& rule = rules_[std::size_t(r)];
      int yeses = 0, opens = 0;
      Literal last = 0;
      for (int i = 0; i < rule.size; ++i) {
        const Literal a = rule.literals[std::size_t(i)];
        if (open(a)) {
          ++opens;
          last = a;
        } else {
          yeses += state(a);
        }
      }
      if (opens > 1) continue;
      const int noes = rule.size - opens - yeses;
      int wanted = -1;  // what the last literal must be
      if (rule.size == 3 && yeses > 0 && noes > 0) continue;
      if (rule.size == 3) wanted = yeses > 0 ? 0 : 1;
      if (rule.size == 4) wanted = yeses % 2;
      if (opens == 0) {
        if (rule.size == 3 || wanted == 1) return false;
        continue;
      }
      values_[std::size_t(last / 2)] = std::uint8_t(wanted ^ (last & 1));
      trail_.push_back(last / 2);
    }
  }
  return true;
}

void LayerSolver::undo(std::size_t to) {
  while (trail_.size() > to) {
    values_[std::size_t(trail_.back())] = is_open;
    trail_.pop_back();
  }
}

bool LayerSolver::is_live(const Rule& rule) const {
  int yeses = 0, noes = 0;
  for (int i = 0; i < rule.size; ++i) {
    const Literal a = rule.literals[std::size_t(i)];
    if (!open(a)) ++(state(a) == 1 ? yeses : noes);
  }
  return rule.size == 3 ? yeses == 0 || noes == 0 : yeses + noes < 4;
}

std::vector<std::vector<int>> LayerSolver::split(const std::vector<int>& part) {
  ++stamp_;
  std::vector<std::vector<int>> pieces;
  for (const int first : part) {
    if (values_[std::size_t(first)] != is_open || mark_[std::size_t(first)] == stamp_) continue;
    std::vector<int> piece{first};
    mark_[std::size_t(first)] = stamp_;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const int r : rules_of_[std::size_t(piece[i])]) {
        const Rule& rule = rules_[std::size_t(r)];
        if (!is_live(rule)) continue;
        for (int k = 0; k < rule.size; ++k) {
          const int v = rule.literals[std::size_t(k)] / 2;
          if (values_[std::size_t(v)] != is_open || mark_[std::size_t(v)] == stamp_) continue;
          mark_[std::size_t(v)] = stamp_;
          piece.push_back(v);
        }
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

int LayerSolver::busiest(const std::vector<int>& part) const {
  int best = part[0];
  std::size_t most = 0;
  for (const int v : part) {
    std::size_t live = 0;
    for (const int r : rules_of_[std::size_t(v)]) live += is_live(rules_[std::size_t(r)]) ? 1 : 0;
    if (live > most) {
      most = live;
      best = v;
    }
  }
  return best;
}

std::vector<std::vector<int>> LayerSolver::parts() {
  std::vector<int> all;
  for (int v = 0; v < int(values_.size()); ++v) {
    if (values_[std::size_t(v)] == is_open && root(2 * v) == 2 * v) all.push_back(v);
  }
  return split(all);
}

bool LayerSolver::choose(const std::vector<int>& part) {
  const int variable = busiest(part);
  for (const int value : {0, 1}) {
    const std::size_t before = trail_.size();
    bool good = assign(variable, value);
    if (good) {
      for (const auto& piece : split(part)) good = good && choose(piece);
    }
    if (good) return true;
    undo(before);
  }
  return false;
}

bool LayerSolver::value(int variable) const {
  return state(root(2 * variable)) == 1;
}

}  // namespace hada
