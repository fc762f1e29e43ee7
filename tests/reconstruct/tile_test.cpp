#include "reconstruct/tile.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(SortingNetwork, SortsAnyNumberOfValues) {
  for (int count = 1; count < 40; ++count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(uniform(2, count, i));
    for (const auto& [low, high] : sorting_network(count)) {
      if (values[std::size_t(low)] > values[std::size_t(high)]) {
        std::swap(values[std::size_t(low)], values[std::size_t(high)]);
      }
    }
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end())) << count;
  }
}

}  // namespace
}  // namespace hada
