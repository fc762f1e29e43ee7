// How many solutions the conditions on layers have: the counting half of LayerSolver.
#include <algorithm>

#include "core/random.h"
#include "sheet/layer_solver.h"

namespace hada {
namespace {

std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t most) {
  return a != 0 && b > most / a ? most : std::min(most, a * b);
}

}  // namespace

std::array<std::uint64_t, 2> LayerSolver::signature(std::vector<int> part) const {
  std::array<std::uint64_t, 2> sums{part.size(), 1};
  const auto add = [&](std::int64_t value) {
    sums = {hash(sums[0], value, 1), hash(sums[1], value, 2)};
  };
  std::sort(part.begin(), part.end());
  for (const int v : part) {
    add(v);
    for (const int r : rules_of_[std::size_t(v)]) {
      const Rule& rule = rules_[std::size_t(r)];
      int yeses = 0, noes = 0;
      for (int i = 0; i < rule.size; ++i) {
        const Literal a = rule.literals[std::size_t(i)];
        if (!open(a)) ++(state(a) == 1 ? yeses : noes);
      }
      // What matters of the values that are fixed: of three, whether both occur; of four, parity.
      add(rule.size == 3 ? (yeses > 0 ? 1 : 0) + (noes > 0 ? 2 : 0) : yeses % 2);
    }
  }
  return sums;
}

std::uint64_t LayerSolver::count(const std::vector<int>& part, std::uint64_t most) {
  const int variable = busiest(part);
  std::uint64_t sum = 0;
  for (const int value : {0, 1}) {
    const std::size_t before = trail_.size();
    if (assign(variable, value)) {
      std::uint64_t states = 1;
      const auto pieces = split(part);
      for (const auto& piece : pieces) {
        const bool may_come_again = pieces.size() > 1;
        states =
            product(states, may_come_again ? remembered(piece, most) : count(piece, most), most);
        if (states == 0) break;
      }
      sum = states > most - sum ? most : sum + states;
    }
    undo(before);
  }
  return sum;
}

std::uint64_t LayerSolver::remembered(const std::vector<int>& part, std::uint64_t most) {
  const auto key = signature(part);
  if (const auto known = counted_.find(key); known != counted_.end()) return known->second;
  const std::uint64_t states = count(part, most);
  counted_.emplace(key, states);
  return states;
}

}  // namespace hada
