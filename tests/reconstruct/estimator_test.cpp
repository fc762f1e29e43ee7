#include "reconstruct/estimator.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Estimator, IsFoundByItsName) {
  for (const Estimator estimator : every_estimator) {
    EXPECT_EQ(estimator_named(name_of(estimator)), estimator);
  }
  EXPECT_FALSE(estimator_named("best").has_value());
}

TEST(Estimator, HasTheNamesOfTheManual) {
  EXPECT_EQ(name_of(Estimator::least_squares), "least-squares");
  EXPECT_EQ(name_of(default_estimator), "adaptive");
}

}  // namespace
}  // namespace hada
