#include "app/fold_log_file.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

using testing::HasSubstr;

TEST(FoldLogFile, OfEveryShippedLogIsWrittenAsItWasRead) {
  const auto folder = std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic" / "folds";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string text = fold_log_text(read_fold_log(entry.path()));
    const FoldLog again = fold_log_of(text, "again");
    EXPECT_EQ(fold_log_text(again), text);
    const FoldLog log = read_fold_log(entry.path());
    ASSERT_EQ(again.steps.size(), log.steps.size());
    for (std::size_t i = 0; i < log.steps.size(); ++i) {
      EXPECT_EQ(again.steps[i].stiff, log.steps[i].stiff);
      EXPECT_EQ(again.steps[i].faces, log.steps[i].faces);
      EXPECT_EQ(again.steps[i].mountains, log.steps[i].mountains);
      EXPECT_EQ(again.steps[i].valleys, log.steps[i].valleys);
      EXPECT_EQ(again.steps[i].note, log.steps[i].note);
    }
  }
}

TEST(FoldLogFile, NamesAKeyThatAStepDoesNotHave) {
  try {
    fold_log_of(R"({"hada": "fold_log/1", "steps": [{"do": "flatten", "stiff": true}]})", "log");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("steps[0]"));
    EXPECT_THAT(error.what(), HasSubstr("stiff"));
  }
}

}  // namespace
}  // namespace hada
