#include "core/quantile.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Quantile, IsTheValueThatAShareLiesBelow) {
  const std::vector<int> values{9, 1, 5, 3, 7};
  EXPECT_EQ(quantile(values, 0.0), 1);
  EXPECT_EQ(median(values), 5);
  EXPECT_EQ(quantile(values, 0.8), 9);
  EXPECT_EQ(quantile(values, 1.0), 9);
}

TEST(Quantile, TakesTheUpperOfTwoInTheMiddle) {
  EXPECT_EQ(median(std::vector<double>{4.0, 1.0, 3.0, 2.0}), 3.0);
}

}  // namespace
}  // namespace hada
