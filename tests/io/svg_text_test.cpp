#include "io/svg_text.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

TEST(SvgText, IsReadTagByTag) {
  const std::string text = "<?xml?><!-- <a/> --><G id='1'><line x2=\"3\"/></G>";
  std::size_t at = 0;
  const auto group = next_tag(text, at, "a.svg");
  const auto line = next_tag(text, at, "a.svg");
  const auto end = next_tag(text, at, "a.svg");
  ASSERT_TRUE(group && line && end);
  EXPECT_EQ(group->name, "g");
  EXPECT_TRUE(line->alone);
  EXPECT_EQ(line->attributes.at("x2"), "3");
  EXPECT_TRUE(end->closes);
  EXPECT_FALSE(next_tag(text, at, "a.svg"));
}

TEST(SvgText, KnowsColoursInAllTheirSpellings) {
  const std::array<int, 3> red{255, 0, 0};
  for (const char* text : {"#f00", "#FF0000", "rgb(255, 0, 0)", "red"})
    EXPECT_EQ(colour_of(text), red) << text;
  EXPECT_FALSE(colour_of("none"));
}

TEST(SvgText, AppliesTransformsFromTheRight) {
  const auto moved = transform_of("translate(10 0) scale(2)") * Eigen::Vector2d(1.0, 3.0);
  EXPECT_NEAR((moved - Eigen::Vector2d(12.0, 6.0)).norm(), 0.0, 1e-12);
}

TEST(SvgText, TakesShapesForStraightStrokes) {
  EXPECT_EQ(strokes_of({"rect", {{"width", "3"}, {"height", "2"}}}, "a").size(), 4u);
  EXPECT_EQ(strokes_of({"polyline", {{"points", "0,0 1,1 2,0"}}}, "a").size(), 2u);
  EXPECT_EQ(strokes_of({"path", {{"d", "M0 0h1v1z"}}}, "a").size(), 3u);
  EXPECT_TRUE(strokes_of({"circle", {{"r", "1"}}}, "a").empty());
  EXPECT_EQ(declarations("stroke: red; opacity: .5").at("opacity"), ".5");
  EXPECT_EQ(rules_of(".st0{stroke:#FF0000;}").at("st0").at("stroke"), "#FF0000");
}

}  // namespace
}  // namespace hada
