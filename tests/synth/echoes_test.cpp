#include "synth/echoes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

constexpr Extent window{.rows = 80, .cols = 96, .pitch = 0.1, .unit = Unit::mm};

WrinkleComponent<> slanted_kernel() {
  return {.amplitude_mm = 0.3, .long_mm = 0.4, .short_mm = 0.2, .angle_rad = 0.7};
}

Grid<float> window_at(const EchoLattice& lattice, const std::array<double, 2>& middle) {
  Grid<float> field(window.rows, window.cols);
  lattice.add_to(field, window, middle, 5);
  return field;
}

// The mean over many windows of the product of places that lie so many pixels apart.
double covariance(const EchoLattice& lattice, int down, int right) {
  double sum = 0.0, count = 0.0;
  for (int k = 0; k < 40; ++k) {
    const auto field = window_at(lattice, {70.0 * k, -40.0 * k});
    for (int row = 0; row + down < window.rows; ++row) {
      for (int col = 0; col + right < window.cols; ++col, ++count) {
        sum += double(field(row, col)) * double(field(row + down, col + right));
      }
    }
  }
  return sum / count;
}

TEST(Echoes, ResembleThemselvesLessEachTime) {
  for (const double repeats : {0.4, 1.0, 3.0, 30.0}) {
    const auto loudness = echoes_of({1.0, 0.0}, repeats).loudness;
    const int last = int(loudness.size()) - 1;
    for (int n = 0; n <= std::min(last, int(3.0 * repeats)); ++n) {
      double sum = 0.0;
      for (int m = -last; m <= last; ++m) {
        const int other = std::abs(m + n);
        if (other <= last) {
          sum += loudness[std::size_t(std::abs(m))] * loudness[std::size_t(other)];
        }
      }
      // What is left out is a hundred thousandth each, of both sides.
      EXPECT_NEAR(sum, std::exp(-0.5 * n * n / (repeats * repeats)), 1e-4) << repeats << " " << n;
    }
  }
}

TEST(EchoLattice, OfNoEchoesIsThePlainNoise) {
  const auto kernel = slanted_kernel();
  const Step<> step{1.0, 0.5};
  const auto lattice =
      EchoLattice::find(kernel, {step, {1.0}}, none_across(step, kernel), window.pitch);
  ASSERT_TRUE(lattice);
  // 40 windows of 9.6 x 8 mm hold 40 x 77 / (4 pi 0.4 x 0.2) = 3000 independent patches: the
  // variance is known to sqrt(2 / 3000) = 2.6 %; three times that. 0.4 mm down and 0.3 mm right:
  const double along = std::cos(0.7) * 0.3 - std::sin(0.7) * 0.4;
  const double across = -std::cos(0.7) * 0.4 - std::sin(0.7) * 0.3;
  const double likeness = std::exp(-0.25 * (along * along / 0.16 + across * across / 0.04));
  EXPECT_NEAR(covariance(*lattice, 0, 0) / 0.09, 1.0, 0.08);
  EXPECT_NEAR(covariance(*lattice, 4, 3) / 0.09, likeness, 0.08);
}

TEST(EchoLattice, ComesBackTwoWaysThatCrossAtASlant) {
  const auto lattice = EchoLattice::find(slanted_kernel(), echoes_of({2.0, 0.0}, 1.0),
                                         echoes_of({1.0, -1.5}, 0.8), window.pitch);
  ASSERT_TRUE(lattice);
  const double variance = covariance(*lattice, 0, 0);
  // About a sixth as many independent patches: a likeness is known to 4 %; three times that.
  EXPECT_NEAR(covariance(*lattice, 0, 20) / variance, std::exp(-0.5), 0.12);
  EXPECT_NEAR(covariance(*lattice, 15, 10) / variance, std::exp(-0.5 / 0.64), 0.12);
  EXPECT_NEAR(covariance(*lattice, 15, 30) / variance, std::exp(-0.5 - 0.5 / 0.64), 0.12);
  EXPECT_NEAR(covariance(*lattice, 7, 10) / variance, 0.0, 0.12);  // between two crossings
}

TEST(EchoLattice, MeetsItsNeighbourWithoutASeam) {
  const auto lattice = EchoLattice::find(slanted_kernel(), echoes_of({2.0, 0.3}, 2.0),
                                         echoes_of({1.0, -1.5}, 1.0), window.pitch);
  const auto here = window_at(*lattice, {3.0, 1.0});
  const auto right = window_at(*lattice, {7.8, -0.6});  // 48 columns, 16 rows
  for (int row = 16; row < 80; ++row) {
    for (int col = 48; col < 96; ++col)
      ASSERT_NEAR(here(row, col), right(row - 16, col - 48), 1e-5);
  }
}

TEST(EchoLattice, IsNoneWhereStepsAreOneDirectionOrKernelsFarFinerThanAPixel) {
  const auto one = echoes_of({2.0, 0.0}, 1.0);
  const auto kernel = slanted_kernel();
  EXPECT_FALSE(EchoLattice::find(kernel, one, echoes_of({1.0, 0.0}, 1.0), 0.1));
  EXPECT_FALSE(EchoLattice::find(kernel, one, none_across(one.step, kernel), 10.0));
  EXPECT_TRUE(EchoLattice::find(kernel, one, none_across(one.step, kernel), 1.0));
}

TEST(EchoLattice, RefusesMoreNodesThanAMemoryHolds) {
  const auto lattice = EchoLattice::find(slanted_kernel(), echoes_of({90.0, 0.0}, 30.0),
                                         echoes_of({0.0, 90.0}, 30.0), window.pitch);
  ASSERT_TRUE(lattice);
  Grid<float> field(window.rows, window.cols);
  EXPECT_THROW(lattice->add_to(field, window, {0.0, 0.0}, 1), Error);
}

}  // namespace
}  // namespace hada
