#include "sheet/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using testing::HasSubstr;

std::string error_of(const FoldFrame& frame) {
  try {
    sheet_of(frame, "a.fold");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Sheet, FindsTheFacesBetweenLinesThatCross) {
  Lines lines;
  lines.square(4.0).add(Crease::mountain, 0, 2, 4, 2).add(Crease::valley, 2, 0, 2, 4);
  const Sheet sheet = sheet_of(lines.frame, "cross");
  EXPECT_EQ(sheet.vertices(), 9);
  EXPECT_EQ(sheet.edges(), 12);
  EXPECT_EQ(sheet.faces(), 4);
  // Euler: V - E + F = 1 for a disc.
  EXPECT_EQ(sheet.vertices() - sheet.edges() + sheet.faces(), 1);
}

TEST(Sheet, LinksEverySideOfAnEdge) {
  const Sheet sheet = sheet_of(vertex_fold({0, 60, 180, 300}, "MVVV"), "vertex");
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    EXPECT_EQ(sheet.origin(sheet.half(h).next), sheet.target(h));
    EXPECT_EQ(sheet.half(sheet.half(h).next).face, sheet.half(h).face);
  }
}

TEST(Sheet, TurnsFacesCounterClockwise) {
  FoldFrame frame = flat_frame(square_sheet(1.0));
  std::reverse(frame.faces[0].begin(), frame.faces[0].end());
  const Sheet sheet = sheet_of(frame, "square");
  EXPECT_EQ(sheet.corners_of(0).size(), 4u);
  const auto corners = sheet.corners_of(0);
  const auto& a = sheet.flat[std::size_t(corners[0])];
  const auto& b = sheet.flat[std::size_t(corners[1])];
  const auto& c = sheet.flat[std::size_t(corners[2])];
  EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0.0);
}

TEST(Sheet, JoinsLinesThatMissEachOtherByAHair) {
  // Three decimals, as drawing programs write them: the fold ends 0.003 short of the border.
  Lines lines;
  lines.square(100.0).add(Crease::valley, 50.0, 0.003, 50.0, 100.0);
  EXPECT_EQ(sheet_of(lines.frame, "hand").faces(), 2);
}

TEST(Sheet, SaysWhatIsWrong) {
  Lines loose;
  loose.square(4.0).add(Crease::mountain, 1, 2, 3, 2);
  EXPECT_THAT(error_of(loose.frame), HasSubstr("a fold ends loosely near (1.0"));
  FoldFrame bent = flat_frame(square_sheet(1.0));
  bent.vertices[0].z() = 1.0;
  EXPECT_THAT(error_of(bent), HasSubstr("is not flat"));
  FoldFrame twice = flat_frame(square_sheet(1.0));
  twice.faces.push_back(twice.faces[0]);
  EXPECT_THAT(error_of(twice), HasSubstr("lies over face 0"));
  FoldFrame open = flat_frame(square_sheet(1.0));
  open.faces[0].pop_back();
  EXPECT_THAT(error_of(open), HasSubstr("no edge"));
  EXPECT_THAT(error_of(FoldFrame{}), HasSubstr("has no edges"));
}

}  // namespace
}  // namespace hada
