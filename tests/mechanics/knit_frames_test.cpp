#include "mechanics/knit_frames.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(KnitFrames, PackWhatLiesWithinThemAndUnpackIt) {
  Eigen::Matrix3d turned;
  turned << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const KnitFrames frames{2, {Eigen::Matrix3d::Identity(), turned, turned}};
  const std::vector<bool> pinned{false, false, true};
  const auto packed = within(frames, pinned, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  ASSERT_EQ(packed.size(), 6);
  const Places back = in_space(frames, pinned, packed);
  EXPECT_EQ(back[0], Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(back[1], Eigen::Vector3d(0, 5, 6));  // the third axis of its frame is x
  EXPECT_EQ(back[2], Eigen::Vector3d(0, 0, 0));
}

TEST(KnitFrames, ResistsAsASpringDoesButForItsPush) {
  const Eigen::Vector3d u(1, 0, 0);
  const auto taut = pulling_stiffness(u, 2.0, 3.0, 6.0);
  EXPECT_DOUBLE_EQ(taut(0, 0), 2.0);
  EXPECT_DOUBLE_EQ(taut(1, 1), 0.5);
  const auto slack = pulling_stiffness(u, 2.0, -3.0, 6.0);
  EXPECT_GT(slack(1, 1), 0.0);
}

}  // namespace
}  // namespace hada
