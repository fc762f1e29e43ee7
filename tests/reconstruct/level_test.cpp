#include "reconstruct/level.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "scenes.h"

namespace hada {
namespace {

Grid<float> quadratic(int rows, int cols, double bend) {
  const Relief relief = relief_of(rows, cols, [bend](double x, double y) {
    return Eigen::Vector3d(5.0 + 0.1 * x - 0.2 * y + bend * (x * x - x * y), 0.0, 0.0);
  });
  Grid<float> height(rows, cols);
  for (std::size_t i = 0; i < height.size(); ++i) height[i] = float(relief.height[i]);
  return height;
}

float largest(const Grid<float>& height) {
  float most = 0.0f;
  for (const float value : height) most = std::max(most, std::abs(value));
  return most;
}

// Heights up to 20 px are floats: 1e-6 each; the fit averages that, the rest shows it.
constexpr float rounding = 3e-6f;

TEST(Level, TakesAPlaneOffWhateverTheMask) {
  Grid<float> height = quadratic(40, 50, 0.0);
  const Mask mask = torn_mask(40, 50, 1);
  level(height, mask, Levelling::plane);
  EXPECT_LT(largest(height), rounding);
}

TEST(Level, TakesAQuadraticOff) {
  Grid<float> height = quadratic(40, 50, 0.01);
  level(height, Mask(40, 50, 1), Levelling::quadratic);
  EXPECT_LT(largest(height), rounding);
}

TEST(Level, TakesOnlyTheMeanOffWhenAskedForTheOffset) {
  Grid<float> height = quadratic(40, 50, 0.01);
  const Grid<float> before = height;
  level(height, Mask(40, 50, 1), Levelling::offset);
  double sum = 0.0;
  for (const float value : height) sum += value;
  EXPECT_NEAR(sum / 2000.0, 0.0, rounding);
  EXPECT_NEAR(height(3, 4) - height(30, 40), before(3, 4) - before(30, 40), rounding);
}

TEST(Level, SurvivesAMaskThatIsASingleLine) {
  Grid<float> height = quadratic(40, 50, 0.0);
  Mask mask(40, 50, 0);
  for (auto& inside : mask.row(7)) inside = 1;
  level(height, mask, Levelling::plane);
  EXPECT_LT(largest(height), rounding);
}

TEST(Level, GivesTheSameBytesAtAnyThreadCount) {
  Grid<float> one = quadratic(41, 50, 0.01);
  Grid<float> two = one;
  set_threads(1);
  level(one, Mask(41, 50, 1), Levelling::plane);
  set_threads(2);
  level(two, Mask(41, 50, 1), Levelling::plane);
  set_threads(0);
  EXPECT_EQ(one, two);
}

TEST(Levelling, HasANameForAPerson) {
  EXPECT_EQ(name_of(Levelling::offset), "offset");
  EXPECT_EQ(name_of(Levelling::plane), "plane");
  EXPECT_EQ(name_of(Levelling::quadratic), "quadratic");
}

}  // namespace
}  // namespace hada
