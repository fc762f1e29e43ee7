#include <gtest/gtest.h>

#include "bench/light_study.h"

namespace hada {
namespace {

// Eight lights beside a matte sphere, four captures: 64 components of direction. A share of 0.9 of
// them has a standard deviation of 0.04, twice that as those of one capture share their outline.
void expect_honest(const LightStudyOptions& options, double error_deg) {
  const LightStudy study = study_lights(options);
  EXPECT_GT(study.coverage90, 0.9 - 2.0 * 0.08);
  EXPECT_LT(study.typical_z, 1.5);
  // And the intervals are not just wide: their width goes with the error.
  EXPECT_GT(study.typical_z, 0.5);
  EXPECT_LT(study.median_error_deg, error_deg);
}

// 0.1 px of an outline of 40 px is 0.14 degrees; the shading knows it ten times better.
TEST(LightIntervals, HoldTheTruthOfDistantLights) {
  expect_honest({.seeds = 4}, 0.05);
}

// An uneven sheet knows its plane to a part of its relief: 0.2 mm of 300.
TEST(LightIntervals, HoldTheTruthOfNearLamps) {
  expect_honest({.seeds = 4, .near = true}, 0.1);
}

}  // namespace
}  // namespace hada
