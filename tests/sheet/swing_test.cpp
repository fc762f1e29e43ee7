#include "sheet/swing.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/crease.h"
#include "sheet/places.h"
#include "sheet/simulate.h"
#include "sheet/strain.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;

double most_strain(const Sheet& sheet) {
  const auto strains = face_strains(sheet);
  return *std::max_element(strains.begin(), strains.end());
}

// The crease between the faces that hold two places of the flat sheet.
int between(const Sheet& sheet, const Vector2d& a, const Vector2d& b) {
  const int first = face_at(sheet, a), second = face_at(sheet, b);
  for (const int h : sheet.halves_of(first)) {
    if (sheet.half(h ^ 1).face == second) return h / 2;
  }
  return -1;
}

// A sheet with a face turned by radians.
Swung swung(const Sheet& sheet, const Swing& swing, double angle, const std::string& where) {
  Swinging swinging(sheet, swing, {}, where);
  swinging.further(angle);
  return swinging.now();
}

// A unit square with creases x = 1/4 and x = 3/4.
Sheet three_panels() {
  Sheet sheet = square_sheet(1.0);
  for (const double x : {0.25, 0.75}) {
    insert_crease(sheet, sheet.folded, straight_cut({x, -1}, {x, 2}, 1e-9), Crease::flat);
  }
  return sheet;
}

TEST(Swing, TurnsOneSideOfACreaseThatPartsThePaper) {
  const Sheet sheet = three_panels();
  Swing swing{.face = face_at(sheet, {0.9, 0.5})};
  swing.axis = between(sheet, {0.9, 0.5}, {0.5, 0.5});
  const Sheet up = swung(sheet, swing, 60.0 * degree, "panels").sheet;
  // It rises towards the print: a valley.
  EXPECT_NEAR(up.fold_angles[std::size_t(swing.axis)], 60.0 * degree, 1e-15);
  EXPECT_EQ(up.creases[std::size_t(swing.axis)], Crease::valley);
  const Vector3d end = folded_place(up, swing.face, {1.0, 0.5});
  EXPECT_LT((end - Vector3d(0.75 + 0.125, 0.5, 0.25 * std::sin(60.0 * degree))).norm(), 1e-15);
  // With a pin on it the rest of the sheet turns instead.
  swing.pinned = {swing.face};
  const Sheet held = swung(sheet, swing, 60.0 * degree, "panels").sheet;
  EXPECT_EQ(folded_place(held, swing.face, {1.0, 0.5}), Vector3d(1.0, 0.5, 0.0));
  EXPECT_GT(folded_place(held, face_at(held, {0.1, 0.5}), {0.0, 0.5}).z(), 0.5);
  EXPECT_NEAR(held.fold_angles[std::size_t(swing.axis)], 60.0 * degree, 1e-15);
  swing.pinned.push_back(face_at(sheet, {0.1, 0.5}));
  EXPECT_THROW(swung(sheet, swing, 60.0 * degree, "panels"), Error);
  swing.axis = sheet.edges();
  swing.axis = between(sheet, {0.1, 0.5}, {0.5, 0.5});
  EXPECT_THROW(swung(sheet, swing, 60.0 * degree, "panels"), Error);  // no crease of that face
}

TEST(Swing, TakesAllLayersOrTheFlapAlone) {
  // Folded in half: two layers, and a crease through both.
  Sheet sheet = square_sheet(1.0);
  insert_crease(sheet, sheet.folded, straight_cut({0.5, -1}, {0.5, 2}, 1e-9), Crease::flat);
  Swing half{.face = face_at(sheet, {0.9, 0.5})};
  half.axis = between(sheet, {0.9, 0.5}, {0.1, 0.5});
  sheet = swung(sheet, half, 180.0 * degree, "half").sheet;
  insert_crease(sheet, sheet.folded, straight_cut({-1, 0.3}, {2, 0.3}, 1e-9), Crease::flat);
  Swing flap{.face = face_at(sheet, {0.1, 0.1})};
  flap.axis = between(sheet, {0.1, 0.1}, {0.1, 0.5});
  // Both layers hang together along x = 0.5, so that one cannot turn alone.
  flap.all = true;
  const Sheet both = swung(sheet, flap, 30.0 * degree, "both").sheet;
  EXPECT_NEAR(folded_place(both, face_at(both, {0.9, 0.1}), {1.0, 0.0}).z(),
              folded_place(both, face_at(both, {0.1, 0.1}), {0.0, 0.0}).z(), 1e-12);
  EXPECT_LT(most_strain(both), 1e-12);
}

TEST(Swing, LeadsLinkedFacesAlongTheClosedForm) {
  // A Miura vertex with sectors of 60 and 120 degrees: tan(minor / 2) = cos(60) tan(major / 2).
  Sheet sheet = sheet_of(vertex_fold({0, 60, 180, -60}, "MVVV"), "miura");
  SimulateOptions start;
  start.share = 0.2;
  sheet.folded = simulate(sheet, start).places;
  sheet.fold_angles = edge_angles(sheet, sheet.folded);
  const auto at = [](double deg) {
    return Vector2d(1.0 + 0.3 * std::cos(deg * degree), 1.0 + 0.3 * std::sin(deg * degree));
  };
  Swing swing{.face = face_at(sheet, at(120))};
  swing.axis = between(sheet, at(120), at(30));           // the crease at 60 degrees
  const int straight = between(sheet, at(120), at(240));  // and at 180
  for (const double further : {20.0, 40.0, -30.0}) {
    const double before = sheet.fold_angles[std::size_t(swing.axis)];
    sheet = swung(sheet, swing, further * degree, "miura").sheet;
    const double major = sheet.fold_angles[std::size_t(swing.axis)];
    EXPECT_NEAR(major, before + further * degree, 1e-9);
    const double minor = 2.0 * std::atan(std::cos(60.0 * degree) * std::tan(0.5 * major));
    EXPECT_NEAR(sheet.fold_angles[std::size_t(straight)], minor, 1e-6);
    EXPECT_LT(most_strain(sheet), 1e-9);
  }
  // What the hand sees meanwhile.
  swing.most_steps = 2;
  swing.strain = 1e-3;
  EXPECT_LT(most_strain(swung(sheet, swing, 5.0 * degree, "miura").sheet), 1e-3);
}

TEST(Swing, OfLinkedFacesStopsWhereTheyMeet) {
  // The same vertex, led beyond the place where all its faces lie on each other.
  Sheet sheet = sheet_of(vertex_fold({0, 60, 180, -60}, "MVVV"), "miura");
  SimulateOptions start;
  start.share = 0.2;
  sheet.folded = simulate(sheet, start).places;
  sheet.fold_angles = edge_angles(sheet, sheet.folded);
  Swing swing{.face = face_at(sheet, {0.85, 1.26})};
  swing.axis = between(sheet, {0.85, 1.26}, {1.26, 1.15});
  const double before = sheet.fold_angles[std::size_t(swing.axis)];
  const Swung stopped = swung(sheet, swing, 200.0 * degree, "miura");
  ASSERT_TRUE(stopped.met);
  // Its stages end at 0.01 degrees; faces that shut may touch a little before.
  EXPECT_NEAR((before + stopped.angle) / degree, 180.0, 0.1);
  EXPECT_LT(most_strain(stopped.sheet), 1e-9);
}

TEST(Swing, SaysWherePaperWouldStretch) {
  // Three creases meet: a vertex of degree three is stiff.
  const Sheet sheet = sheet_of(vertex_fold({0, 120, 240}, "MMM"), "stiff");
  Swing swing{.face = face_at(sheet, {1.2, 1.2})};
  swing.axis = between(sheet, {1.2, 1.2}, {0.7, 1.0});
  EXPECT_TRUE(swung(sheet, swing, 30.0 * degree, "stiff").stuck);
}

}  // namespace
}  // namespace hada
