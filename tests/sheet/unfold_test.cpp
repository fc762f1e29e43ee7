#include "sheet/unfold.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/simulate.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

TEST(UnfoldedSheet, IsTheOneThatWasFolded) {
  Sheet sheet = sheet_of(vertex_fold({10, 70, 190, -50}, "MVVV"), "vertex");
  sheet.folded = simulate(sheet, {.share = 0.5}).places;
  const Sheet again = unfolded_sheet(folded_frame(sheet), "vertex");
  ASSERT_EQ(again.vertices(), sheet.vertices());
  EXPECT_EQ(again.faces(), sheet.faces());
  for (std::size_t a = 0; a < sheet.flat.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      // Rigid faces within 1e-9, laid one beside the other around one vertex.
      EXPECT_NEAR((again.flat[a] - again.flat[b]).norm(), (sheet.flat[a] - sheet.flat[b]).norm(),
                  1e-7);
    }
  }
}

TEST(UnfoldedSheet, NeedsFacesThatHangTogether) {
  FoldFrame frame;
  frame.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  frame.edges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
  frame.faces = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_THROW(unfolded_sheet(frame, "parts"), Error);
}

}  // namespace
}  // namespace hada
