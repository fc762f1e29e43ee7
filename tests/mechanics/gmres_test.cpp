#include "mechanics/gmres.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Gmres, SolvesWhatIsNotSymmetric) {
  Eigen::Matrix3d matrix;
  matrix << 4, 1, 0, -1, 3, 1, 0, 0.5, 2;
  const Eigen::Vector3d right(1, 2, 3);
  const auto solved = gmres([&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return matrix * x; },
                            [](const Eigen::VectorXd& x) { return x; }, right, 1e-12);
  EXPECT_LT((matrix * solved.x - right).norm(), 1e-10);
  EXPECT_LE(solved.directions, 3);  // no more than there are unknowns
  EXPECT_EQ(gmres([](const Eigen::VectorXd& x) { return x; },
                  [](const Eigen::VectorXd& x) { return x; }, Eigen::VectorXd::Zero(2), 1e-9)
                .directions,
            0);
}

}  // namespace
}  // namespace hada
