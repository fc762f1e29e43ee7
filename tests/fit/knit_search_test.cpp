#include "fit/knit_search.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "made_photographs.h"

namespace hada {
namespace {

// The rests of a piece at ratios that are not the one it is made with.
PulledShapes shapes_of(const MadePhotographs& made, double stretch) {
  MadePhotographs other = made;
  PulledShapes shapes;
  for (const double ratio : {0.3, 3.5, 30.0}) {
    shapes.log_ratios.push_back(std::log(ratio));
    shapes.places.push_back(other.piece(ratio, stretch).places);
  }
  return shapes;
}

Knit<> at_rest(const MadePhotographs& made) {
  Knit<> knit = made.knit();
  knit.wale_phase = 0.5, knit.course_phase = 0.5;
  return knit;
}

TEST(KnitSearch, MixesTheNearestShapes) {
  PulledShapes shapes{{0.0, 1.0}, {{{0, 0, 0}}, {{2, 4, 0}}}};
  EXPECT_EQ(shapes.at(-1.0)[0], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(shapes.at(0.25)[0], Eigen::Vector3d(0.5, 1, 0));
  EXPECT_EQ(shapes.at(3.0)[0], Eigen::Vector3d(2, 4, 0));
}

TEST(KnitSearch, TellsAPieceFromOneHalfAStitchAside) {
  MadePhotographs made;
  made.side = 10;
  const auto rest = tracked_picture(made.rest(), 1.8);
  const StitchLook look = look_of(rest, at_rest(made));
  const KnitNet net = made.net(made.side, 1.0);
  const auto shapes = shapes_of(made, 1.5);
  // Shifts between those that are looked at, up to two thirds of a course.
  Seed key = 10;
  for (const auto& [turn, shift] :
       {std::array{0.0, 0.9}, {0.02, -0.3}, {-0.03, 0.55}, {0.045, -1.0}}) {
    const BentKnit truth = made.piece(10.0, 1.5, turn, shift);
    const auto picture = tracked_picture(made.pulled_piece(truth, 1.5, ++key), 1.8);
    const auto even = placements(picture, look, net, shapes, 0);
    const auto odd = placements(picture, look, net, shapes, 1);
    const auto& found = even[0].likeness > odd[0].likeness ? even : odd;
    const auto off = [&](const PlacedKnit& placed) {
      double sum = 0.0;
      for (std::size_t k = 0; k < truth.places.size(); ++k) {
        sum += (placed.bent.places[k] - truth.places[k]).norm() / double(truth.places.size());
      }
      return sum;
    };
    // What tracking starts from must be right to a fifth of a course of 1.5 mm.
    EXPECT_LT(off(found[0]), 0.3) << turn << " " << shift;
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_LE(found[k].likeness, found[k - 1].likeness);
      EXPECT_GT(off(found[k]), 0.5);  // no place twice: a third of a stitch apart
    }
  }
}

}  // namespace
}  // namespace hada
