#include "sheet/layer_solver.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(LayerSolver, CountsWhatTryingAllCounts) {
  constexpr int variables = 10;
  for (Seed seed = 0; seed < 200; ++seed) {
    LayerSolver solver(variables);
    std::vector<std::array<int, 5>> rules;  // kind, literals
    for (int i = 0; i < 9; ++i) {
      std::array<int, 5> rule{int(4 * uniform(seed, i, 0)), 0, 0, 0, 0};
      for (int k = 1; k < 5; ++k) rule[std::size_t(k)] = int(2 * variables * uniform(seed, i, k));
      if (i > 2 && rule[0] < 2) rule[0] += 2;  // few equalities, else nothing is left
      rules.push_back(rule);
    }
    std::uint64_t expected = 0;
    for (int bits = 0; bits < 1 << variables; ++bits) {
      const auto yes = [&](int literal) { return ((bits >> (literal / 2)) ^ literal) & 1; };
      bool good = true;
      for (const auto& [kind, a, b, c, d] : rules) {
        const int sum = yes(a) + yes(b) + yes(c);
        if (kind == 0) good = good && yes(a) == yes(b);
        if (kind == 1) good = good && yes(a);
        if (kind == 2) good = good && sum > 0 && sum < 3;
        if (kind == 3) good = good && (sum + yes(d)) % 2 == 0;
      }
      expected += good;
    }
    bool possible = true;
    for (const auto& [kind, a, b, c, d] : rules) {
      if (kind == 0) possible = possible && solver.equal(a, b);
      if (kind == 1) possible = possible && solver.fix(a);
      if (kind == 2) solver.not_all_equal(a, b, c);
      if (kind == 3) solver.even(a, b, c, d);
    }
    std::uint64_t counted = possible && !solver.simplify() ? 1 : 0;
    if (counted > 0) {
      for (const auto& part : solver.parts()) {
        counted *= solver.count(part, 1u << 20);
        EXPECT_EQ(solver.choose(part), counted > 0);
        if (counted == 0) break;
      }
    }
    EXPECT_EQ(counted, expected) << "seed " << seed;
    for (const auto& [kind, a, b, c, d] : rules) {
      if (counted == 0) break;
      const auto yes = [&](int literal) { return int(solver.value(literal / 2)) ^ (literal & 1); };
      const int sum = yes(a) + yes(b) + yes(c);
      EXPECT_TRUE(kind != 0 || yes(a) == yes(b));
      EXPECT_TRUE(kind != 1 || yes(a) == 1);
      EXPECT_TRUE(kind != 2 || (sum > 0 && sum < 3));
      EXPECT_TRUE(kind != 3 || (sum + yes(d)) % 2 == 0);
    }
  }
}

}  // namespace
}  // namespace hada
