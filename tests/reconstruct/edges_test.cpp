#include "reconstruct/edges.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(EdgeWeights, AreOneOverTheMeanVarianceOfBothPixels) {
  Grid<float> weight(1, 2);
  weight(0, 0) = 1.0f;
  weight(0, 1) = 0.25f;
  EXPECT_EQ(edge_weights(weight).east(0, 0), 0.4f);  // 1 / mean(1, 4)
}

TEST(RisesOf, AreMeansOfSlopesInsideTheMaskAndRunDownTheRows) {
  SlopeMap slopes(2, 2, Eigen::Vector2f(1.0f, 4.0f));
  slopes(0, 1) = Eigen::Vector2f(3.0f, 4.0f);
  slopes(1, 0) = Eigen::Vector2f(1.0f, 2.0f);
  Mask mask(2, 2, 1);
  mask(1, 1) = 0;
  const EdgeRises rises = rises_of(slopes, mask);
  EXPECT_EQ(rises.east(0, 0), 2.0f);
  EXPECT_EQ(rises.south(0, 0), -3.0f);  // y is up
  EXPECT_EQ(rises.south(0, 1), 0.0f);
  EXPECT_EQ(rises.east(1, 0), 0.0f);
}

}  // namespace
}  // namespace hada
