#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"
#include "bench/fold_study.h"

namespace hada {
namespace {

TEST(CreasePatterns, FoldAsOthersFoldThem) {
  if (!std::filesystem::exists(data_folder() / "fold")) {
    GTEST_SKIP() << "the crease patterns are not in " << data_folder();
  }
  for (const auto& score : score_patterns(data_folder(), 1)) {
    EXPECT_EQ(score.states, score.states_published) << score.name;
    // Both sides agree among themselves to 5e-11; a hundredfold of that for chains of faces.
    EXPECT_LT(score.geometry_error, 1e-9) << score.name;
  }
}

TEST(CreasePatterns, ThatDoNotFoldAreRejectedWithAReason) {
  if (!std::filesystem::exists(data_folder() / "fold")) {
    GTEST_SKIP() << "the crease patterns are not in " << data_folder();
  }
  for (const auto& rejection : score_unfoldable(data_folder())) {
    EXPECT_FALSE(rejection.reason.empty()) << rejection.name;
  }
}

}  // namespace
}  // namespace hada
