#include "fit/figure.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double dive_at(int row, int col) {
  return 0.12 * std::sin(0.21 * row + 0.05 * col) + 0.05 * std::cos(0.13 * col);
}

/// Nine pictures with 1 % of noise, quantised to 16 bits.
LightStack board(double specular, double sharpness, Seed seed, int side = 48) {
  LightStack stack;
  stack.camera.extent = {side, side, 0.2, Unit::mm};
  stack.mask = Mask(side, side, 1);
  for (int k = 0; k < 9; ++k) {
    const double along = (-32.0 + 8.0 * k) * degree, across = (k % 3 - 1) * 8.0 * degree;
    Light light;
    light.direction = Eigen::Vector3d(std::sin(across) * std::cos(along), std::sin(along),
                                      std::cos(across) * std::cos(along));
    light.strength *= 0.9 + 0.025 * k;
    Grid<float> picture(side, side);
    for (int row = 0; row < side; ++row) {
      for (int col = 0; col < side; ++col) {
        const double matte = 0.3 + 0.1 * std::sin(0.9 * col);
        const double lobe = std::pow(std::cos(along - dive_at(row, col)), sharpness);
        const double value = light.strength.x() * (matte * light.direction.z() + specular * lobe) *
                             (1.0 + 0.01 * gaussian(seed, k, row, col));
        picture(row, col) = float(std::round(value * 65535.0) / 65535.0);
      }
    }
    stack.images.push_back(Image(picture));
    stack.lights.push_back(light);
    stack.samples.push_back(Grid<Sample>(side, side, Sample::lit));
  }
  return stack;
}

TEST(Figure, IsReadFromNinePictures) {
  const auto figure = figure_of(board(0.15, 20.0, 3));
  // What nine lights and 1 % of noise must allow.
  EXPECT_NEAR(figure.specular, 0.15, 0.02 * 0.15);
  EXPECT_NEAR(figure.sharpness, 20.0, 0.03 * 20.0);
  constexpr int side = 48;
  double sum = 0.0, holds = 0.0;
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const double error = figure.dive_rad(row, col) - dive_at(row, col);
      sum += std::abs(error) / (side * side);
      holds += std::abs(error) < 1.645 * figure.dive_sigma(row, col) ? 1.0 / (side * side) : 0.0;
    }
  }
  EXPECT_LT(sum, 0.7 * degree);
  // 2304 pixels know the share to 0.6 %; noise grows with the brightness, sigma takes it for even.
  EXPECT_NEAR(holds, 0.9, 0.04);
}

TEST(Figure, KnowsHowSureItIs) {
  double squares = 0.0;
  constexpr int seeds = 12;
  for (Seed seed = 0; seed < seeds; ++seed) {
    const auto figure = figure_of(board(0.15, 20.0, 10 + seed, 20));
    squares += std::pow((figure.sharpness - 20.0) / figure.sharpness_sigma, 2) / seeds;
  }
  // 1, known to sqrt(2 / 12) = 0.4 from twelve seeds: three of those.
  EXPECT_LT(squares, 2.2);
  EXPECT_GT(squares, 0.2);
}

TEST(Figure, LeavesOutWhatIsSaturated) {
  constexpr int side = 32;
  auto stack = board(0.15, 20.0, 3, side);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      stack.images[4].planes[0](row, col) = 5.0f;
      stack.samples[4](row, col) = Sample::saturated;
    }
  }
  const auto figure = figure_of(stack);
  EXPECT_NEAR(figure.sharpness, 20.0, 1.5);
}

TEST(Figure, RefusesWhatCannotBeTold) {
  EXPECT_THROW(figure_of(board(0.15, 1.0, 4, 20)), Error);  // as wide as diffuse light
  EXPECT_THROW(figure_of(board(0.0, 20.0, 5, 20)), Error);  // none
  auto few = board(0.15, 20.0, 6);
  few.images.resize(4);
  few.lights.resize(4);
  EXPECT_THROW(figure_of(few), Error);
  // Turned by a right angle, the lights lie across what is taken for the trunk.
  EXPECT_THROW(figure_of(board(0.15, 20.0, 7), {.trunk_rad = std::numbers::pi}), Error);
}

TEST(Figure, IsTheSameAtAnyThreadCount) {
  set_threads(1);
  const auto one = figure_of(board(0.15, 20.0, 8, 20));
  set_threads(2);
  const auto two = figure_of(board(0.15, 20.0, 8, 20));
  set_threads(0);
  EXPECT_EQ(one.sharpness, two.sharpness);
  EXPECT_TRUE(std::equal(one.dive_rad.begin(), one.dive_rad.end(), two.dive_rad.begin()));
}

}  // namespace
}  // namespace hada
