#include "sheet/strain.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sheet/simulate.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

TEST(FaceStrains, AreTheShareThatIsStretched) {
  Sheet sheet = square_sheet(2.0);
  EXPECT_NEAR(face_strains(sheet)[0], 0.0, 1e-15);
  for (auto& p : sheet.folded) p.x() *= 1.01;
  EXPECT_NEAR(face_strains(sheet)[0], 0.01, 1e-12);  // its sides along x; diagonals half as much
}

TEST(FaceStrains, SeeAFaceBend) {
  // One corner of a unit square is lifted by h: the sides there grow to sqrt(1 + h^2), the diagonal
  // to sqrt(2 + h^2).
  Sheet sheet = square_sheet(1.0);
  sheet.folded[2].z() = 0.2;
  EXPECT_NEAR(face_strains(sheet)[0], std::sqrt(1.04) - 1.0, 1e-12);
}

TEST(FaceStrains, OfAFoldedSheetAreNone) {
  Sheet sheet = sheet_of(strip(4, Crease::valley), "strip");
  sheet.folded = simulate(sheet, {.share = 0.3}).places;
  for (const double strain : face_strains(sheet)) EXPECT_LT(strain, 1e-9);
}

}  // namespace
}  // namespace hada
