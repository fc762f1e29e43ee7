#include "capture/virtual_scene.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "table_scene.h"

namespace hada {
namespace {

Surface flat_sheet(double side_mm) {
  Surface sheet = waved_sheet(side_mm);
  for (float& height : sheet.height) height = 0.0f;
  return sheet;
}

Rig lit_from_above() {
  Rig rig = table_rig({});
  rig.lights = {light_at(0, 0), light_at(60, 0)};
  return rig;
}

TEST(VirtualScene, PutsTheSheetOnTheFineLattice) {
  const auto place = place_of(flat_sheet(24.0), lit_from_above());
  EXPECT_EQ(place.oversampling, 4);
  // The lattice is 800 x 1200; the sheet of 480 cells has its centre 12 mm, 240 cells, to the
  // right.
  EXPECT_EQ(place.row, 400 - 240);
  EXPECT_EQ(place.col, 600 + 240 - 240);
}

TEST(VirtualScene, IsAsBrightAsLambertSays) {
  const Surface sheet = flat_sheet(24.0);
  const Rig rig = lit_from_above();
  const VirtualScene scene(sheet, rig);
  ASSERT_TRUE(scene.shows_sheet(400, 840));
  EXPECT_FALSE(scene.shows_sheet(400, 300));
  std::vector<double> on_sheet(2, 0.0), on_table(2, 0.0);
  scene.add_cell(400, 840, on_sheet);
  scene.add_cell(400, 300, on_table);
  // A light 60 degrees off the normal sends half.
  EXPECT_NEAR(on_sheet[1] / on_sheet[0], 0.5, 1e-6);
  EXPECT_NEAR(on_table[0] / on_sheet[0], rig.table_albedo / 0.8, 1e-6);
}

TEST(VirtualScene, RefusesASheetThatDoesNotFit) {
  EXPECT_THROW(place_of(flat_sheet(60.0), lit_from_above()), Error);
  Rig coarse = lit_from_above();
  coarse.pitch_mm = 0.17;  // not a whole number of cells
  EXPECT_THROW(place_of(flat_sheet(24.0), coarse), Error);
}

}  // namespace
}  // namespace hada
