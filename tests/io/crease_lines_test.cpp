#include "io/crease_lines.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

TEST(CreaseLines, OfCpHaveTheirKinds) {
  const auto frame = lines_of_cp("1 0 0 1 0\n2 0 0 1 1\r\n3 0 1 1 0\n0 0 0.5 1 0.5\n", "a.cp");
  ASSERT_EQ(frame.edges.size(), 4u);
  EXPECT_EQ(frame.vertices.size(), 8u);  // no line shares its ends with another
  EXPECT_EQ(frame.crease(0), Crease::border);
  EXPECT_EQ(frame.crease(1), Crease::mountain);
  EXPECT_EQ(frame.crease(2), Crease::valley);
  EXPECT_EQ(frame.crease(3), Crease::flat);
}

TEST(CreaseLines, OfOpxAreTheSame) {
  const auto frame = lines_of_opx(
      "<java><object class=\"oripa.OriLineProxy\">"
      "<void property=\"type\"><int>2</int></void>"
      "<void property=\"x0\"><double>-200.0</double></void>"
      "<void property=\"y0\"><double>-200.0</double></void>"
      "<void property=\"x1\"><double>200.0</double></void>"
      "<void property=\"y1\"><double>200.0</double></void></object></java>",
      "a.opx");
  ASSERT_EQ(frame.edges.size(), 1u);
  EXPECT_EQ(frame.crease(0), Crease::mountain);
  EXPECT_NEAR((frame.vertices[1] - frame.vertices[0]).norm(), 400.0 * std::sqrt(2.0), 1e-9);
}

TEST(CreaseLines, ThatAreBrokenAreRefused) {
  EXPECT_THROW(lines_of_cp("2 0 0 1\n", "a.cp"), Error);
  EXPECT_THROW(lines_of_cp("2 0 0 1 nan\n", "a.cp"), Error);
}

}  // namespace
}  // namespace hada
