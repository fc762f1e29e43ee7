#include "fit/knit_track.h"

#include <gtest/gtest.h>

#include "made_photographs.h"

namespace hada {
namespace {

// Where the stitches of a made picture at rest lie, the origin between four of 22 x 22.
Knit<> at_rest(const MadePhotographs& made) {
  Knit<> knit = made.knit();
  knit.wale_phase = 0.5, knit.course_phase = 0.5;
  knit.colour_repeat = {0.0, 1.0};  // course 10 is an even one
  return knit;
}

TEST(KnitTrack, LooksAsTheStitchesOfThePictureDo) {
  const MadePhotographs made;
  const auto picture = tracked_picture(made.rest(), 0.7);
  const StitchLook look = look_of(picture, at_rest(made));
  ASSERT_EQ(look.courses.size(), 2u);
  for (const auto& course : look.courses) {
    for (const auto& sample : course) {
      EXPECT_LE(std::abs(sample.wale), 0.5);
      EXPECT_LE(std::abs(sample.course), 0.5 + 1e-9);
    }
  }
  // In its own picture: all but noise and mottle is explained, and hardly anything a wale aside.
  const auto flat = pulled(made.net(12, 10.0), KnitPull::wale, KnitClamp::uniform, 1.0);
  BentKnit bent{12, 12, flat.start};
  for (auto& p : bent.places) p.y() += 1.5;  // 12 courses about the middle begin with an odd one
  const auto mean = [&](int first) { return mean_likeness(picture, look, bent, first); };
  EXPECT_GT(std::max(mean(0), mean(1)), 0.9);
  EXPECT_LT(std::min(mean(0), mean(1)), std::max(mean(0), mean(1)) - 0.25);
}

TEST(KnitTrack, FindsCrossingsToATenthOfAStitchFromAFifth) {
  const MadePhotographs made;
  const BentKnit truth = made.piece(10.0, 1.2);
  const Surface photograph = made.pulled_piece(truth, 1.2, 2);
  const Surface rest = made.rest();
  std::vector<TrackedPicture> levels;
  std::vector<StitchLook> looks;
  for (const double px : {1.8, 0.7}) {
    levels.push_back(tracked_picture(photograph, px));
    looks.push_back(look_of(tracked_picture(rest, px), at_rest(made)));
  }
  BentKnit guess = truth;
  for (auto& p : guess.places) p += Eigen::Vector3d(0.2, -0.15, 0.0);  // a tenth of a stitch
  const auto mean = [&](int first) { return mean_likeness(levels[1], looks[1], truth, first); };
  const int first = mean(0) > mean(1) ? 0 : 1;
  const BentKnit found = tracked(levels, looks, guess, first);
  double sum = 0.0;
  int inner = 0;
  for (int j = 2; j < 6; ++j) {
    for (int i = 2; i < 6; ++i, ++inner) {
      const auto k = std::size_t(j * 8 + i);
      sum += (found.places[k] - truth.places[k]).squaredNorm();
    }
  }
  EXPECT_LT(std::sqrt(sum / inner), 0.15);  // mm, what the header says; the guess is 0.25 off
}

}  // namespace
}  // namespace hada
