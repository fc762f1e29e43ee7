#include "sheet/flat_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using testing::HasSubstr;

std::vector<FlatFlaw> flaws_of(const std::vector<double>& degrees, const std::string& letters) {
  return flat_flaws(sheet_of(vertex_fold(degrees, letters), "vertex"));
}

TEST(FlatCheck, PassesAVertexThatObeysBothTheorems) {
  EXPECT_TRUE(flaws_of({0, 60, 180, 300}, "MVVV").empty());  // 60 + 120 twice
  EXPECT_TRUE(flaws_of({0, 60, 180, 300}, "UUUU").empty());
  EXPECT_TRUE(flaws_of({0, 60, 180, 300}, "FFFF").empty());
}

TEST(FlatCheck, NamesKawasakiWithTheAngles) {
  const auto flaws = flaws_of({0, 50, 180, 300}, "MVVV");  // 50 + 120 and 130 + 60
  ASSERT_EQ(flaws.size(), 1u);
  EXPECT_THAT(flaws[0].reason, HasSubstr("190.0000 and 170.0000 degrees"));
  EXPECT_THAT(flaws[0].reason, HasSubstr("at (1, 1)"));
  EXPECT_THAT(flaws_of({0, 120, 240}, "MMM")[0].reason, HasSubstr("3 folds meet"));
}

TEST(FlatCheck, NamesMaekawaWithTheCounts) {
  const auto flaws = flaws_of({0, 60, 180, 300}, "MMVV");
  ASSERT_EQ(flaws.size(), 1u);
  EXPECT_THAT(flaws[0].reason, HasSubstr("2 mountains and 2 valleys"));
}

}  // namespace
}  // namespace hada
