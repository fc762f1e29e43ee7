#include "reconstruct/graph_factors.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(GraphFactors, SolveEveryRegionWithZeroMean) {
  // A path of three, its first edge listed in two parts, and a pair.
  const GraphFactors factors(5, {{0, 1, 0.5}, {1, 0, 1.5}, {1, 2, 4.0}, {3, 4, 1.0}});
  Eigen::VectorXd values(5);
  values << -4.0, 0.0, 4.0, 1.0, -1.0;  // a force of 4 along the path, of 1 back along the pair
  factors.solve(values);
  EXPECT_NEAR(values[1] - values[0], 2.0, 1e-12);
  EXPECT_NEAR(values[2] - values[1], 1.0, 1e-12);
  EXPECT_NEAR(values.head(3).sum(), 0.0, 1e-12);
  EXPECT_NEAR(values[3], 0.5, 1e-12);
  EXPECT_NEAR(values[4], -0.5, 1e-12);
}

}  // namespace
}  // namespace hada
