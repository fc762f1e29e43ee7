#include "app/report/plot.h"

#include <gtest/gtest.h>

#include "app/report/html.h"

namespace hada {
namespace {

TEST(Plot, TicksAreRoundNumbersInsideTheAxis) {
  EXPECT_EQ(ticks({"", false, 0.0, 10.0}), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks({"", true, 0.5, 2000.0}), (std::vector<double>{1, 10, 100, 1000}));
}

TEST(Plot, LogAxisLeavesOutWhatHasNoLogarithm) {
  const Axis axis = axis_over("", true, {0.0, -1.0, 2.0, 8.0});
  EXPECT_GT(axis.low, 1.0);
  EXPECT_GT(axis.high, 8.0);
}

TEST(Plot, MeasuredIsDrawnAsPointsAndModelsAsLines) {
  const std::string svg =
      plot({"x"}, {"y"},
           {{.name = "m", .x = {0.5}, .y = {0.5}, .sigma = {0.1}},
            {.name = "f", .mark = Series::Mark::line, .x = {0.1, 0.9}, .y = {0.1, 0.9}}});
  EXPECT_NE(svg.find("<circle"), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
}

TEST(Html, TextCannotBecomeMarkup) {
  EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

}  // namespace
}  // namespace hada
