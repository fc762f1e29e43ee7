#include "app/part_order.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

const WrinkleComponent<> large{0.35, 14.0, 6.0, 0.4};
const WrinkleComponent<> small{0.04, 1.8, 0.9, 2.5};
const WrinkleComponent<> noise{0.0002, 0.7, 0.4, 1.0};

TEST(PartOrder, FindsEachPartWhateverTheOrderAndLeavesOutTheRest) {
  const Material found = Wrinkle<>{.components = {noise, small, large}};
  const Material truth = Wrinkle<>{.components = {large, small}};
  EXPECT_EQ(part_order(found, truth), (std::vector<int>{2, 1}));
  EXPECT_EQ(values_of(reordered(found, part_order(found, truth))), values_of(truth));
}

TEST(PartOrder, IsEmptyWhereTooFewWereFound) {
  const Material found = Wrinkle<>{.components = {small}};
  const Material truth = Wrinkle<>{.components = {large, small}};
  EXPECT_TRUE(part_order(found, truth).empty());
}

}  // namespace
}  // namespace hada
