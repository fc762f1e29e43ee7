#include <vector>

#include <gtest/gtest.h>

#include "sheet/layer_solver.h"

/// The counting half of LayerSolver, by orders that are known to be n!.
namespace hada {
namespace {

/// The conditions of `piles` piles of `sheets` sheets each, every pair a variable: a over b.
LayerSolver piles_of(int sheets, int piles) {
  const int pairs = sheets * (sheets - 1) / 2;
  LayerSolver solver(piles * pairs);
  for (int pile = 0; pile < piles; ++pile) {
    const auto over = [&](int a, int b) {
      return 2 * (pile * pairs + a * sheets - a * (a + 1) / 2 + b - a - 1);
    };
    for (int a = 0; a < sheets; ++a) {
      for (int b = a + 1; b < sheets; ++b) {
        for (int c = b + 1; c < sheets; ++c)
          solver.not_all_equal(over(a, b), over(b, c), over(a, c) + 1);
      }
    }
  }
  return solver;
}

TEST(LayerCount, OfAPileIsTheNumberOfItsOrders) {
  const std::vector<std::uint64_t> factorial{1, 1, 2, 6, 24, 120, 720};
  for (int sheets = 3; sheets <= 6; ++sheets) {
    LayerSolver solver = piles_of(sheets, 1);
    ASSERT_FALSE(solver.simplify());
    const auto parts = solver.parts();
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(solver.count(parts[0], 1u << 20), factorial[std::size_t(sheets)]);
  }
}

TEST(LayerCount, CountsPilesThatDoNotTouchSeparately) {
  LayerSolver solver = piles_of(4, 3);
  ASSERT_FALSE(solver.simplify());
  const auto parts = solver.parts();
  ASSERT_EQ(parts.size(), 3u);
  for (const auto& part : parts) EXPECT_EQ(solver.count(part, 1u << 20), 24u);
}

TEST(LayerCount, StopsAtTheMostThatIsAsked) {
  LayerSolver solver = piles_of(6, 1);
  ASSERT_FALSE(solver.simplify());
  const auto parts = solver.parts();
  EXPECT_EQ(solver.count(parts[0], 100), 100u);
}

}  // namespace
}  // namespace hada
