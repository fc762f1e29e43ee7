#include "sheet/flaps.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

// A strip of four panels, cut along x = 2; what lies to the left of the line upwards moves.
struct Cut {
  Sheet sheet = sheet_of(strip(4, Crease::valley), "strip");
  CreaseCut cut = straight_cut({2, -1}, {2, 2}, 1e-9);
  std::vector<int> creases = insert_crease(sheet, sheet.folded, cut, Crease::flat);
};

double middle_of(const Sheet& sheet, int face) {
  double sum = 0.0;
  const auto corners = sheet.corners_of(face);
  for (const int v : corners) sum += sheet.flat[std::size_t(v)].x();
  return sum / double(corners.size());
}

TEST(Flaps, MoveWhereTheyHangToTheLeft) {
  const Cut strip;
  ASSERT_EQ(strip.creases.size(), 1u);  // the fold that was there
  const auto moving = moving_faces(strip.sheet, strip.creases, strip.cut, "strip");
  for (int f = 0; f < strip.sheet.faces(); ++f) {
    EXPECT_EQ(moving[std::size_t(f)], middle_of(strip.sheet, f) < 2.0);
  }
  EXPECT_THROW(moving_faces(strip.sheet, {}, strip.cut, "strip"), Error);
}

TEST(Flaps, AreWhatCreasesPartOff) {
  const Cut strip;
  const std::vector<bool> all(4, true);
  auto flaps = flaps_of(strip.sheet, all, strip.creases);
  EXPECT_EQ(std::count(flaps.begin(), flaps.end(), 0), 2);
  EXPECT_EQ(std::count(flaps.begin(), flaps.end(), 1), 2);
  flaps = flaps_of(strip.sheet, moving_faces(strip.sheet, strip.creases, strip.cut, "strip"),
                   strip.creases);
  EXPECT_EQ(std::count(flaps.begin(), flaps.end(), -1), 2);
}

TEST(Flaps, OutermostIsWhatNoOtherCovers) {
  // Three faces, all with their print up, one on the other; the last one lies apart below.
  Cut strip;
  const std::vector<int> flap{0, 1, 2, 3};
  const std::vector<FaceOrder> pile{{0, 1, -1}, {1, 2, -1}, {0, 2, -1}};  // 2 on 1 on 0
  for (std::size_t v = 0; v < strip.sheet.folded.size(); ++v) {
    if (strip.sheet.flat[v].x() > 3.5) strip.sheet.folded[v].z() = -1.0;
  }
  EXPECT_EQ(outermost_flap(strip.sheet, pile, flap, 1), 2);
  EXPECT_EQ(outermost_flap(strip.sheet, pile, flap, -1), 0);
  // Where none covers another it is the one that is furthest out; in a ring there is none.
  const int lowest = outermost_flap(strip.sheet, {}, flap, -1);
  EXPECT_GT(middle_of(strip.sheet, lowest), 3.0);
  EXPECT_EQ(outermost_flap(strip.sheet, {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}}, flap, 1), -1);
}

}  // namespace
}  // namespace hada
