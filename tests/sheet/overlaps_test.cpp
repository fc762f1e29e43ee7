#include "sheet/overlaps.h"

#include <gtest/gtest.h>

#include "tests/sheet/patterns.h"

namespace hada {
namespace {

TEST(BitSet, HoldsNumbersBeyondAWord) {
  BitSet one(200), two(200);
  for (const int i : {0, 63, 64, 199}) one.toggle(i);
  two.toggle(64);
  EXPECT_EQ(one.members(), (std::vector<int>{0, 63, 64, 199}));
  EXPECT_TRUE(one.meets(two));
  EXPECT_EQ((one & two).members(), std::vector<int>{64});
  two.toggle(64);
  EXPECT_FALSE(one.meets(two));
}

TEST(Overlaps, OfAnAccordionAreOneCell) {
  const Sheet sheet = sheet_of(strip(5, Crease::unassigned), "strip");
  const Overlaps found = overlaps(sheet, flat_state(sheet));
  ASSERT_EQ(found.faces_of.size(), 1u);
  EXPECT_EQ(found.faces_of[0].members().size(), 5u);
}

TEST(Overlaps, CoverAsMuchAsThePaper) {
  // A panel of 2 on one of 1: the one cell has both, the other the longer alone; and the cells of
  // each face together are as large as it.
  Lines lines;
  lines.add(Crease::border, 0, 0, 3, 0).add(Crease::border, 3, 0, 3, 1);
  lines.add(Crease::border, 3, 1, 0, 1).add(Crease::border, 0, 1, 0, 0);
  lines.add(Crease::valley, 1, 0, 1, 1);
  const Sheet sheet = sheet_of(lines.frame, "halves");
  const Overlaps found = overlaps(sheet, flat_state(sheet));
  ASSERT_EQ(found.faces_of.size(), 2u);
  std::size_t cells = 0, covers = 0;
  for (const BitSet& of : found.cells_of) cells += of.members().size();
  for (const BitSet& of : found.faces_of) covers += of.members().size();
  EXPECT_EQ(cells, 3u);
  EXPECT_EQ(covers, 3u);
}

}  // namespace
}  // namespace hada
