#include "reconstruct/row_arithmetic.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(RowArithmetic, WhatWasDealtIsGathered) {
  for (const int size : {33, 34}) {
    std::vector<float> row(34, 0.0f);
    for (int i = 0; i < size; ++i) row[std::size_t(i)] = float(i);
    std::vector<float> even(17), odd(17), again(34, 1.0f);
    row_kernels::deal(17, row.data(), even.data(), odd.data());
    EXPECT_EQ(even[3], 6.0f);
    EXPECT_EQ(odd[3], 7.0f);
    std::vector<float> back(34, -1.0f);
    row_kernels::gather(size, even.data(), odd.data(), back.data());
    row[33] = size == 34 ? 33.0f : -1.0f;
    EXPECT_EQ(back, row);
    row_kernels::add_gathered(size, 2.0f, even.data(), odd.data(), again.data());
    for (int i = 0; i < 34; ++i) {
      EXPECT_EQ(again[std::size_t(i)], i < size ? float(1 + 2 * i) : 1.0f);
    }
  }
}

TEST(RowArithmetic, AddsUpWholeRows) {
  std::vector<float> row(34);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = float(i);
  EXPECT_EQ(row_kernels::sum(34, row.data()), 33.0 * 34.0 / 2.0);
  EXPECT_EQ(row_kernels::dot(34, row.data(), row.data()), 33.0 * 34.0 * 67.0 / 6.0);
  std::vector<float> twice(34);
  row_kernels::add(34, row.data(), row.data(), twice.data());
  row_kernels::subtract(34, 1.0f, twice.data());
  EXPECT_EQ(twice[33], 65.0f);
}

TEST(RowArithmetic, CountsWhatIsAboveZero) {
  // More than a byte can count in each of 32 lanes, and some beyond whole rows of lanes.
  std::vector<std::uint8_t> bytes(32 * 300 + 7, 200);
  bytes[5] = bytes[9000] = 0;
  EXPECT_EQ(row_kernels::count_positive(bytes.size(), bytes.data()), bytes.size() - 2);
  const std::vector<float> some{1.0f, -1.0f, 0.0f, 0.5f};
  EXPECT_EQ(row_kernels::count_positive(some.size(), some.data()), 2u);
  EXPECT_EQ(row_kernels::count_positive(0, some.data()), 0u);
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
