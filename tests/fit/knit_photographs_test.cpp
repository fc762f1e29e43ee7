#include "fit/knit_photographs.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "fit/knit.h"
#include "made_photographs.h"

namespace hada {
namespace {

TEST(KnitPhotographs, TellHowStiffYarnsAre) {
  const MadePhotographs made;
  const Surface rest = made.rest();
  const Knit<> knit = fit_knit(rest).material;
  ASSERT_EQ(knit.colour_repeat.size(), 2u);
  std::vector<int> repeat;
  for (const double yarn : knit.colour_repeat) repeat.push_back(yarn > 0.5);
  std::vector<KnitPhotograph> photographs;
  std::vector<BentKnit> truth;
  for (const double stretch : {1.2, 1.5}) {
    // Not in the middle of the picture, and a degree aslant.
    truth.push_back(made.piece(10.0, stretch, 0.017, 0.4));
    photographs.push_back({made.pulled_piece(truth.back(), stretch, Seed(truth.size() + 1)),
                           KnitPull::wale, stretch});
  }
  const auto fit =
      fit_photographs(rest, knit, repeat, photographs, {8, 8, KnitClamp::three_points});
  EXPECT_EQ(fit.repeat, (std::vector<int>{0, 1}));
  EXPECT_NEAR(std::log(fit.stiffness.ratio.value / 10.0), 0.0, 4.0 * fit.stiffness.log_ratio_sigma);
  EXPECT_NEAR(fit.stiffness.continuity.value, 0.2, 4.0 * fit.stiffness.continuity.sigma);
  EXPECT_LT(fit.stiffness.log_ratio_sigma, 0.05);
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t k = 0; k < 64; ++k) {
      // A tenth of a course; the phase of the stitch at rest is known to half of that.
      EXPECT_LT((fit.states[s].places[k] - truth[s].places[k]).norm(), 0.15) << s << " " << k;
    }
  }
  EXPECT_THROW(fit_photographs(rest, knit, repeat, {}, {8, 8, KnitClamp::three_points}), Error);
}

}  // namespace
}  // namespace hada
