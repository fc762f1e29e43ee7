#include "sheet/places.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/simulate.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using Eigen::Vector2d;

Sheet folded_vertex() {
  Sheet sheet = sheet_of(vertex_fold({10, 70, 190, -50}, "MVVV"), "vertex");
  sheet.folded = simulate(sheet, {.share = 0.4}).places;
  return sheet;
}

TEST(Places, GoToTheFoldedSheetAndBack) {
  const Sheet sheet = folded_vertex();
  for (const Vector2d& flat : {Vector2d(0.3, 0.4), Vector2d(1.7, 1.1), Vector2d(1.2, 0.1)}) {
    const int face = face_at(sheet, flat);
    ASSERT_GE(face, 0);
    const auto place = folded_place(sheet, face, flat);
    EXPECT_LT((flat_place(sheet, face, place) - flat).norm(), 1e-12);
    // Distances within a face are kept: to its first corner.
    const std::size_t corner = std::size_t(sheet.corners_of(face)[0]);
    EXPECT_NEAR((place - sheet.folded[corner]).norm(), (flat - sheet.flat[corner]).norm(), 1e-9);
  }
}

TEST(Places, BesideThePaperHaveNoFace) {
  const Sheet sheet = folded_vertex();
  EXPECT_EQ(face_at(sheet, {2.1, 1.0}), -1);
  EXPECT_THROW(faces_at(sheet, {{1.0, 0.5}, {-0.1, 0.5}}, "here"), Error);
  EXPECT_TRUE(chosen_faces(sheet, {}, "here").empty());  // no choice is all
  const auto chosen = chosen_faces(sheet, {{0.3, 0.4}}, "here");
  for (int f = 0; f < sheet.faces(); ++f) {
    EXPECT_EQ(chosen[std::size_t(f)], f == face_at(sheet, {0.3, 0.4}));
  }
}

TEST(Places, AreSoFarFromAnEdge) {
  const Sheet sheet = square_sheet(1.0);
  for (int e = 0; e < sheet.edges(); ++e) {
    EXPECT_DOUBLE_EQ(distance_to(sheet, e, {0.5, 0.5}), 0.5);
    // Beyond its ends it is as far as its nearer end.
    const Vector2d far(4.0, 5.0);
    const double ends = std::min((sheet.flat[std::size_t(sheet.origin(2 * e))] - far).norm(),
                                 (sheet.flat[std::size_t(sheet.target(2 * e))] - far).norm());
    EXPECT_DOUBLE_EQ(distance_to(sheet, e, far), ends);
  }
}

}  // namespace
}  // namespace hada
