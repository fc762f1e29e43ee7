#include "reconstruct/remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class Remarks : public testing::Test {
 protected:
  std::vector<std::string> said() const { return remarks_on(stack_, found_); }
  const LightStack stack_ = pictures_of(waves(30, 30), ring_of_lights(8));
  Orientation found_ = solve_normals(stack_);
};

TEST_F(Remarks, AreFewWhereAllIsWell) {
  EXPECT_THAT(said(), Each(Not(HasSubstr("unexplained"))));
  EXPECT_THAT(said(), Each(Not(HasSubstr("regions"))));
}

TEST_F(Remarks, TellWhatNoMatteSurfaceExplains) {
  found_.left_out_error = 0.28;
  EXPECT_THAT(said(), Contains(HasSubstr("leaves 28 % of the pictures unexplained")));
}

TEST_F(Remarks, NameTheLightThatTheOthersContradict) {
  found_.light_errors.assign(8, 0.02);
  found_.light_errors[3] = 0.4;
  const auto remarks = said();
  EXPECT_THAT(remarks, Contains(HasSubstr("off by 40 %")));
  EXPECT_THAT(remarks, Contains(HasSubstr("typical: 2.0 %")));
}

TEST_F(Remarks, TellHowFewSamplesAgree) {
  for (auto& count : found_.inliers) count = 4;
  EXPECT_THAT(said(), Contains(HasSubstr("fewer than 5 samples agree")));
}

TEST(RemarkOnRegions, CountsThoseThatAreNotSpecks) {
  Mask mask(20, 30, 1);
  EXPECT_FALSE(remark_on_regions(mask));
  for (int row = 0; row < 20; ++row) mask(row, 14) = 0;
  ASSERT_TRUE(remark_on_regions(mask));
  EXPECT_THAT(*remark_on_regions(mask), HasSubstr("2 separate regions"));
  // A single pixel is less than a hundredth of all.
  for (int row = 0; row < 20; ++row) {
    for (int col = 15; col < 30; ++col) mask(row, col) = row == 5 && col == 20;
  }
  EXPECT_FALSE(remark_on_regions(mask));
}

}  // namespace
}  // namespace hada
