#include "fit/normal_scores.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace hada {
namespace {

Grid<float> normal_numbers() {
  Grid<float> values(200, 300);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 300; ++col) values(row, col) = float(gaussian(1, row, col));
  }
  return values;
}

TEST(NormalScores, UndoATone) {
  const auto truth = normal_numbers();
  Grid<float> toned = truth;
  for (float& value : toned) value = std::exp(0.3f * value) + 2.0f;
  const auto scores = normal_scores(toned);
  double squares = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    squares += std::pow(double(scores.values[k]) - truth[k], 2);
  // The mean and variance of 60000 numbers are known to 0.4 and 0.3 %, the rest is the curve.
  EXPECT_LT(std::sqrt(squares / double(truth.size())), 0.02);
}

TEST(NormalScores, KeepTheOrder) {
  Grid<float> values = normal_numbers();
  for (float& value : values) value = std::round(4.0f * value);
  const auto scores = normal_scores(values);
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (values[k] > values[k - 1]) {
      ASSERT_GE(scores.values[k], scores.values[k - 1]);
    }
  }
}

TEST(NormalScores, HaveTheSlopeOfTheirCurve) {
  Grid<float> values = normal_numbers();
  for (float& value : values) value *= 10.0f;
  // A line of slope 1 / 10, but for the bins at the ends.
  EXPECT_NEAR(normal_scores(values).log_slope, -std::log(10.0), 0.02);
  EXPECT_NEAR(standard_scores(values).log_slope, -std::log(10.0), 0.01);
}

TEST(NormalScores, InvertTheDistribution) {
  for (const double z : {-5.0, -1.0, 0.0, 0.3, 4.0}) {
    const double p = 0.5 * std::erfc(-z / std::sqrt(2.0));
    EXPECT_NEAR(normal_quantile(p), z, 1e-8);
  }
}

TEST(NormalScores, RefuseOneGrey) {
  EXPECT_THROW(normal_scores(Grid<float>(9, 9, 1.0f)), Error);
  EXPECT_THROW(standard_scores(Grid<float>(9, 9, 1.0f)), Error);
}

}  // namespace
}  // namespace hada
