#include "fit/knit_refine.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "made_photographs.h"

namespace hada {
namespace {

TEST(KnitRefine, FindsCrossingsAsWellAsLoopsLieOnThem) {
  const MadePhotographs made;
  const BentKnit truth = made.piece(10.0, 1.4);
  const Surface photograph = made.pulled_piece(truth, 1.4, 2);
  BentKnit start = truth;
  for (std::size_t k = 0; k < start.places.size(); ++k) {
    start.places[k] +=
        0.15 * Eigen::Vector3d(gaussian(5, std::int64_t(k), 0), gaussian(5, std::int64_t(k), 1), 0);
  }
  const auto found = refined(photograph, made.knit(), start);
  double sum = 0.0;
  for (std::size_t k = 0; k < truth.places.size(); ++k) {
    sum += (found.places[k] - truth.places[k]).squaredNorm();
    EXPECT_GT(found.likeness[k], 0.8);
  }
  // Loops lie off their crossings by 0.01 wale = 0.02 mm each way; two thirds more for the noise of
  // the picture and for pixels of 0.13 mm.
  EXPECT_LT(std::sqrt(sum / 128.0), 0.033);
}

TEST(KnitRefine, SaysWhereThereIsNoSuchStitch) {
  const MadePhotographs made;
  const BentKnit truth = made.piece(10.0, 1.2);
  Surface photograph = made.pulled_piece(truth, 1.2, 2);
  // A finger lies on the right third.
  for (auto& plane : photograph.albedo.planes) {
    for (int row = 0; row < plane.rows(); ++row) {
      for (int col = 2 * plane.cols() / 3; col < plane.cols(); ++col) plane(row, col) = 0.5f;
    }
  }
  const auto found = refined(photograph, made.knit(), truth);
  for (int course = 0; course < 8; ++course) {
    EXPECT_LT(found.likeness[std::size_t(course * 8 + 7)], 0.5);
  }
}

}  // namespace
}  // namespace hada
