#include <cstdio>

#include <gtest/gtest.h>

#include "bench/studio_study.h"

namespace hada {
namespace {

TEST(StudioStudy, AnswersWhileAHandMoves) {
  const auto found = study_drag(std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic/folds");
  EXPECT_GE(found.faces, 150);
  std::printf("%d faces: drag %.2f ms, aim %.2f ms median\n", found.faces, found.drag_ms,
              found.aim_ms);
  // The goal is 5 ms; other work on the machine may take three quarters of it.
  EXPECT_LT(found.drag_ms, 20.0);
  EXPECT_LT(found.aim_ms, 20.0);
  EXPECT_LE(found.strain_dragging, 1e-3);
  EXPECT_LE(found.strain_released, 1e-9);
}

TEST(StudioStudy, AnswersNoneWhoShouldNotAsk) {
  const auto found = study_hostile();
  EXPECT_GT(found.tried, 80);
  EXPECT_EQ(found.succeeded, 0);
  EXPECT_TRUE(found.alive);
}

}  // namespace
}  // namespace hada
