#include "fit/goodness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

/// Cells of a half plane with exponential ordinates of mean 1.
std::vector<Cell> exponential_cells(Seed seed) {
  std::vector<Cell> cells;
  for (int i = -30; i <= 30; ++i) {
    for (int j = 1; j <= 30; ++j) {
      Cell cell{.fx = double(j), .fy = double(i)};
      cell.power = -std::log(uniform(seed, i, j));
      cell.count = 1;
      cells.push_back(cell);
    }
  }
  return cells;
}

TEST(Goodness, IsUniformForATrueModel) {
  int low = 0;
  const int seeds = 400;
  double sum = 0.0;
  for (Seed seed = 0; seed < seeds; ++seed) {
    const auto cells = exponential_cells(seed);
    const double p = goodness_of_fit(cells, std::vector(cells.size(), 1.0), 1.0, 0);
    sum += p / seeds;
    low += p < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(sum, 0.5, 4.0 / std::sqrt(12.0 * seeds));
  EXPECT_NEAR(low, 20, 4.0 * std::sqrt(19.0));  // binomial, 400 times 0.05
}

TEST(Goodness, SeesAModelThatIsTooHighInOneHalf) {
  const auto cells = exponential_cells(3);
  std::vector<double> model(cells.size(), 1.0);
  for (std::size_t i = 0; i < cells.size(); ++i) model[i] = cells[i].fy > 0.0 ? 1.5 : 0.75;
  EXPECT_LT(goodness_of_fit(cells, model, 1.0, 0), 1e-6);
}

TEST(Goodness, IsNotANumberWhereNothingIsLeftToTest) {
  EXPECT_TRUE(std::isnan(goodness_of_fit({}, {}, 1.0, 3)));
}

}  // namespace
}  // namespace hada
