#include "measure/cubic.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

double value_at(const std::vector<double>& values, double place) {
  const Cubic cubic = cubic_at(place, int(values.size()));
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += cubic.weight[k] * values[std::size_t(cubic.first) + k];
  return sum;
}

TEST(Cubic, IsExactForACubicUpToBeyondTheEnds) {
  const auto polynomial = [](double x) { return 2.0 - x + 0.5 * x * x - 0.25 * x * x * x; };
  std::vector<double> values;
  for (int k = 0; k < 7; ++k) values.push_back(polynomial(k));
  for (double place = -0.5; place <= 6.5; place += 0.125)
    EXPECT_NEAR(value_at(values, place), polynomial(place), 1e-12) << place;
}

TEST(Cubic, KeepsTheStepsThemselves) {
  const std::vector<double> values{3.0, -1.0, 4.0, 1.0, -5.0};
  for (int k = 0; k < 5; ++k) EXPECT_EQ(value_at(values, k), values[std::size_t(k)]);
}

TEST(Cubic, ErrsByTheFourthPowerOfTheStepsInAWave) {
  constexpr double step = 2.0 * std::numbers::pi / 32.0;
  std::vector<double> values;
  for (int k = 0; k < 64; ++k) values.push_back(std::sin(step * k));
  double most = 0.0;
  for (double place = 1.0; place <= 62.0; place += 0.1)
    most = std::max(most, std::abs(value_at(values, place) - std::sin(step * place)));
  // (x + 1) x (x - 1) (x - 2) is 9 / 16 in the middle; over 4! times the fourth derivative.
  EXPECT_NEAR(most, std::pow(step, 4) * 9.0 / 16.0 / 24.0, 0.05 * most);
}

}  // namespace
}  // namespace hada
