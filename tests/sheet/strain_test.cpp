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

TEST(FacePlanarities, AreHowFarACornerIsOffTheOthers) {
  // One corner of a unit square is lifted by 4 h: the plane along both diagonals passes all four
  // corners at h, less the cosine of its slant (1 - 4 h^2).
  Sheet sheet = square_sheet(1.0);
  EXPECT_NEAR(face_planarities(sheet)[0], 0.0, 1e-15);
  sheet.folded[2].z() = 0.04;
  EXPECT_NEAR(face_planarities(sheet)[0], 0.01, 1e-5);
}

TEST(FacePlanarities, SeeMoreThanStrains) {
  Sheet sheet = square_sheet(1.0);
  sheet.folded[2].z() = 0.01;
  EXPECT_GT(face_planarities(sheet)[0], 30.0 * face_strains(sheet)[0]);  // h / 4 and h^2 / 2
}

TEST(FacePlanarities, OfAFoldedSheetAreNone) {
  Sheet sheet = sheet_of(strip(4, Crease::valley), "strip");
  sheet.folded = simulate(sheet, {.share = 0.3}).places;
  for (const double off : face_planarities(sheet)) EXPECT_LT(off, 1e-9);
}

}  // namespace
}  // namespace hada
