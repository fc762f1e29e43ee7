#include "sheet/layers.h"

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using testing::HasSubstr;

Layers layers_of(const FoldFrame& frame, const LayerOptions& options = {}) {
  const Sheet sheet = sheet_of(frame, "pattern");
  return layer_orders(sheet, flat_state(sheet), options);
}

// Foldings of a strip of n stamps, by trying all orders: joints on one side must not interlock.
int stamp_foldings(int count, Crease crease) {
  std::vector<int> place(std::size_t(count), 0);  // of each stamp in the stack
  std::iota(place.begin(), place.end(), 0);
  int good = 0;
  do {
    bool crosses = false;
    for (int i = 0; i + 1 < count; ++i) {
      // Along the strip paper turns over: a valley lays the next stamp on top, then below.
      const bool rises = place[std::size_t(i)] < place[std::size_t(i) + 1];
      crosses = crosses || (crease == Crease::valley && rises != (i % 2 == 0));
      for (int j = i + 2; j + 1 < count; j += 2) {
        const int a = std::min(place[std::size_t(i)], place[std::size_t(i) + 1]);
        const int b = std::max(place[std::size_t(i)], place[std::size_t(i) + 1]);
        const auto inside = [&](int k) {
          return a < place[std::size_t(k)] && place[std::size_t(k)] < b;
        };
        crosses = crosses || inside(j) != inside(j + 1);
      }
    }
    good += !crosses;
  } while (std::next_permutation(place.begin(), place.end()));
  return good;
}

TEST(Layers, CountTheFoldingsOfAStripOfStamps) {
  EXPECT_EQ(stamp_foldings(4, Crease::unassigned), 16);  // OEIS A000136: 1, 2, 6, 16, 50, 144, 462
  for (int count = 2; count <= 7; ++count) {
    const Layers layers = layers_of(strip(count, Crease::unassigned));
    EXPECT_EQ(layers.states(), std::to_string(stamp_foldings(count, Crease::unassigned))) << count;
  }
}

TEST(Layers, OfAPleatAreOne) {
  FoldFrame pleat = strip(6, Crease::valley);
  for (std::size_t e = 4; e < pleat.edges.size(); e += 2) pleat.assignment[e] = Crease::mountain;
  const Layers layers = layers_of(pleat);
  EXPECT_EQ(layers.states(), "1");
  EXPECT_EQ(layers.order.size(), 15u);  // all pairs of six layers
}

TEST(Layers, OfARollAreThoseThatItsValleysAllow) {
  for (int count = 3; count <= 7; ++count) {
    EXPECT_EQ(layers_of(strip(count, Crease::valley)).states(),
              std::to_string(stamp_foldings(count, Crease::valley)));
  }
}

TEST(Layers, ObeyAChosenOrder) {
  const FoldFrame stamps = strip(4, Crease::unassigned);
  const Layers all = layers_of(stamps);
  std::uint64_t sum = 0;
  for (const int order : {1, -1}) {
    const Layers some = layers_of(stamps, {.chosen = {{0, 3, order}}});
    ASSERT_TRUE(some.possible);
    sum += std::stoull(some.states());
    const auto found = std::find_if(some.order.begin(), some.order.end(),
                                    [](const FaceOrder& o) { return o.face == 0 && o.other == 3; });
    ASSERT_NE(found, some.order.end());
    EXPECT_EQ(found->order, order);
  }
  EXPECT_EQ(std::to_string(sum), all.states());
}

TEST(Layers, RefuseAFoldThroughPaper) {
  // The narrow flap of a vertex lies between wide ones: its two folds must differ.
  const Layers layers = layers_of(vertex_fold({0, 40, 180, 320}, "VVVM"));
  EXPECT_TRUE(layers.possible);
  const Layers blocked = layers_of(vertex_fold({0, 30, 150, 270}, "VVMV"));
  EXPECT_FALSE(blocked.possible);
  EXPECT_THAT(blocked.reason, HasSubstr("cannot lie over each other"));
  EXPECT_EQ(blocked.states(), "0");
}

TEST(Layers, MultiplyLargeNumbersInFull) {
  Layers layers;
  layers.possible = true;
  layers.part_states = {1000000007, 1000000007, 1000000007};
  EXPECT_EQ(layers.states(), "1000000021000000147000000343");
}

}  // namespace
}  // namespace hada
