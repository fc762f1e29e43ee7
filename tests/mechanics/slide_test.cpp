#include "mechanics/slide.h"

#include <gtest/gtest.h>

#include "synth/leg.h"

namespace hada {
namespace {

TEST(Slide, ShortensAllWaysOrEach) {
  const Places way{{4, 0, 0}, {0, 1, 0}};
  const auto all = shortened(way, 2.0, false), each = shortened(way, 2.0, true);
  EXPECT_EQ(all[0], Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(all[1], Eigen::Vector3d(0, 0.5, 0));
  EXPECT_EQ(each[0], Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(each[1], Eigen::Vector3d(0, 1, 0));
}

TEST(Slide, SplitsForcesAlongTheBodyAndOntoIt) {
  const Body body(leg_mesh());
  const MeshPlace at = body.tree().closest({40.0, 350.0, 10.0});
  const Eigen::Vector3d force(-1.0, 0.5, 0.2);
  const auto free = on_body(body, {at}, {force}, {}, 0.0);
  EXPECT_NEAR(free.load[0].dot(free.normals[0]), 0.0, 1e-12);
  EXPECT_NEAR((free.load[0] - free.press[0] * free.normals[0] - force).norm(), 0.0, 1e-12);
  EXPECT_FALSE(free.stuck[0]);
  EXPECT_TRUE(on_body(body, {at}, {force}, {true}, 0.0).stuck[0]);
  EXPECT_TRUE(on_body(body, {at}, {force}, {}, 10.0).stuck[0]);
}

}  // namespace
}  // namespace hada
