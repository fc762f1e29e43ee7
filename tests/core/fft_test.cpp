#include "core/fft.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <type_traits>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "core/random.h"

namespace hada {
namespace {

template <class T>
Grid<T> noise(int rows, int cols) {
  Grid<T> grid(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) grid(row, col) = T(gaussian(5, row, col));
  }
  return grid;
}

// The sum of the header, term by term.
template <class T>
std::complex<double> direct_transform(const Grid<T>& real, int i, int j) {
  std::complex<double> sum = 0.0;
  for (int row = 0; row < real.rows(); ++row) {
    for (int col = 0; col < real.cols(); ++col) {
      const double turns = double(i) * row / real.rows() + double(j) * col / real.cols();
      sum += double(real(row, col)) * std::polar(1.0, -2.0 * std::numbers::pi * turns);
    }
  }
  return sum;
}

struct Size {
  int rows;
  int cols;
};

constexpr Size sizes[] = {{1, 1}, {1, 2}, {1, 7}, {1, 8}, {2, 1},  {7, 1},   {8, 1},   {2, 2},
                          {3, 3}, {4, 6}, {5, 8}, {8, 5}, {9, 15}, {16, 12}, {11, 13}, {2, 9}};

template <class T>
class Fft : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Fft, Scalars);

// Both sums have rows * cols <= 200 terms of about 1: 200 roundings of a result of about 14.
template <class T>
constexpr double tolerance = std::is_same_v<T, float> ? 2e-4 : 2e-12;

TYPED_TEST(Fft, IsTheSumThatItsHeaderStates) {
  for (const auto [rows, cols] : sizes) {
    const auto real = noise<TypeParam>(rows, cols);
    const auto half = fft(real);
    ASSERT_EQ(half.rows(), rows);
    ASSERT_EQ(half.cols(), cols / 2 + 1);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < half.cols(); ++j) {
        const auto difference = std::complex<double>(half(i, j)) - direct_transform(real, i, j);
        EXPECT_LT(std::abs(difference), tolerance<TypeParam>) << rows << " x " << cols;
      }
    }
  }
}

TYPED_TEST(Fft, ComesBackByItsInverse) {
  for (const auto [rows, cols] : sizes) {
    const auto real = noise<TypeParam>(rows, cols);
    const auto again = inverse_fft(fft(real), cols);
    ASSERT_TRUE(again.same_size(real));
    for (std::size_t i = 0; i < real.size(); ++i) {
      EXPECT_NEAR(again[i], real[i], tolerance<TypeParam>) << rows << " x " << cols;
    }
  }
}

// Rows and columns are transformed some at a time; here the last ones are fewer.
TYPED_TEST(Fft, OfAPureWaveIsThatWave) {
  constexpr int rows = 150, cols = 77, i = 149, j = 30;
  Grid<TypeParam> wave(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double turns = double(i) * row / rows + double(j) * col / cols;
      wave(row, col) = TypeParam(std::cos(2.0 * std::numbers::pi * turns));
    }
  }
  auto half = fft(wave);
  EXPECT_NEAR(std::abs(half(i, j) - TypeParam(0.5 * rows * cols)), 0.0, 60 * tolerance<TypeParam>);
  half(i, j) = 0.0;
  // Each is a sum of 58 times the terms that the tolerance is for.
  for (const auto& value : half) EXPECT_LT(std::abs(value), 60 * tolerance<TypeParam>);
}

TYPED_TEST(Fft, DoesNotReadTheLowerHalfOfItsMirrors) {
  auto half = fft(noise<TypeParam>(9, 8));
  const auto again = inverse_fft(half, 8);
  half(7, 0) = half(6, 4) = 1e3;
  EXPECT_EQ(inverse_fft(half, 8), again);
}

TEST(FftThreads, GivesTheSameBytesAtAnyThreadCount) {
  const auto real = noise<float>(192, 250);
  set_threads(1);
  const auto half = fft(real);
  const auto back = inverse_fft(half, 250);
  set_threads(3);
  EXPECT_EQ(fft(real), half);
  EXPECT_EQ(inverse_fft(half, 250), back);
  set_threads(0);
}

TEST(FastLength, HasNoLargePrimes) {
  EXPECT_EQ(fast_length(0), 1);
  EXPECT_EQ(fast_length(7), 8);
  EXPECT_EQ(fast_length(11), 12);
  EXPECT_EQ(fast_length(15), 15);
  EXPECT_EQ(fast_length(6145), 6250);  // 6144 = 2^11 3, 6250 = 2 5^5
}

TEST(SignedFrequency, RunsUpToNyquistAndThenFromBelow) {
  EXPECT_EQ(signed_frequency(0, 8), 0);
  EXPECT_EQ(signed_frequency(4, 8), 4);
  EXPECT_EQ(signed_frequency(5, 8), -3);
  EXPECT_EQ(signed_frequency(3, 7), 3);
  EXPECT_EQ(signed_frequency(4, 7), -3);
  EXPECT_EQ(signed_frequency(0, 1), 0);
}

}  // namespace
}  // namespace hada
