#include "reconstruct/row_arithmetic.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(RowArithmetic, SettleToMultiplesThatAreAddedUp) {
  std::vector<float> x{0.15f, -0.15f, 0.062f, 0.063f}, total{1.0f, 2.0f, 3.0f, 4.0f};
  row_kernels::settle(4, 2.0f, 3.0f * 0x1p22f * 0.25f, x.data(), total.data());
  EXPECT_EQ(x, (std::vector<float>{0.25f, -0.25f, 0.0f, 0.25f}));
  EXPECT_EQ(total, (std::vector<float>{1.25f, 1.75f, 3.0f, 4.25f}));
}

TEST(RowArithmetic, DealAndGatherAreInverse) {
  std::vector<float> row(34);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = float(i);
  std::vector<float> even(17), odd(17), again(34);
  row_kernels::deal(17, row.data(), even.data(), odd.data());
  EXPECT_EQ(even[3], 6.0f);
  EXPECT_EQ(odd[3], 7.0f);
  row_kernels::gather(17, even.data(), odd.data(), again.data());
  EXPECT_EQ(again, row);
  EXPECT_EQ(row_kernels::sum(34, row.data()), 33.0 * 34.0 / 2.0);
  EXPECT_EQ(row_kernels::dot(17, even.data(), even.data()), 4.0 * 16.0 * 17.0 * 33.0 / 6.0);
}

TEST(RowArithmetic, FindTheLargestOfEitherSign) {
  std::vector<float> x(37, 0.25f);
  EXPECT_EQ(row_kernels::largest(37, x.data()), 0.25f);
  x[20] = -3.5f;
  x[36] = 2.0f;
  EXPECT_EQ(row_kernels::largest(37, x.data()), 3.5f);
  EXPECT_EQ(row_kernels::largest(0, x.data()), 0.0f);
}

TEST(RowArithmetic, AddsAndDealsAtOnce) {
  const float a[] = {1.0f, 2.0f, 3.0f, 4.0f};
  const float b[] = {10.0f, 20.0f, 30.0f, 40.0f};
  float even[2];
  float odd[2];
  row_kernels::add_and_deal(2, a, b, even, odd);
  EXPECT_EQ(even[0], 11.0f);
  EXPECT_EQ(odd[0], 22.0f);
  EXPECT_EQ(even[1], 33.0f);
  EXPECT_EQ(odd[1], 44.0f);
}

}  // namespace
}  // namespace hada
