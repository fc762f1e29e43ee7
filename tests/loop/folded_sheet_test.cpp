#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"
#include "measure/creases.h"
#include "sheet/simulate.h"
#include "sheet/unfold.h"
#include "synth/folded.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

using Eigen::Vector3d;
constexpr double degree = std::numbers::pi / 180.0;

// The sheet turned so that it lies level on the whole, and moved to the origin.
void lay_level(Sheet& sheet) {
  Vector3d normal = Vector3d::Zero(), mean = Vector3d::Zero();
  for (int f = 0; f < sheet.faces(); ++f) {
    const auto corners = sheet.corners_of(f);
    const Vector3d& a = sheet.folded[std::size_t(corners[0])];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      normal += (sheet.folded[std::size_t(corners[i])] - a)
                    .cross(sheet.folded[std::size_t(corners[i + 1])] - a);
    }
  }
  const auto level = Eigen::Quaterniond::FromTwoVectors(normal, Vector3d::UnitZ());
  for (Vector3d& p : sheet.folded) {
    p = level * p;
    mean += p / double(sheet.folded.size());
  }
  for (Vector3d& p : sheet.folded) p -= mean;
}

TEST(FoldedSheet, IsFoundAgainAroundAVertexOfFourCreases) {
  FoldFrame pattern = vertex_fold({10, 70, 190, -50}, "MVVV");
  for (Vector3d& p : pattern.vertices) p = 40.0 * (p - Vector3d(1.0, 1.0, 0.0));
  Sheet sheet = sheet_of(pattern, "vertex");
  SimulateOptions options;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.creases[std::size_t(e)] == Crease::valley) options.held = {{e, 12.0 * degree}};
  }
  const Simulated shape = simulate(sheet, options);
  sheet.folded = shape.places;
  lay_level(sheet);
  Surface surface = folded_surface(folded_frame(sheet), {420, 420, 0.2, Unit::mm});
  for (int row = 0; row < surface.extent.rows; ++row) {
    for (int col = 0; col < surface.extent.cols; ++col) {
      auto& n = surface.normals(row, col);
      const Vector3d rough(std::tan(degree) * gaussian(5, row, col, 0),
                           std::tan(degree) * gaussian(5, row, col, 1), 0.0);
      n = (n / n.z() + rough.cast<float>()).normalized();
    }
  }
  const MeasuredCreases found = measured_creases(surface);
  ASSERT_EQ(found.creases.size(), 4u);
  ASSERT_EQ(found.inner_vertices.size(), 1u);
  EXPECT_EQ(found.inner_vertices[0].creases, 4);
  // Noise of 1 degree over some 30000 pixels of a facet is 0.006 degrees; angles add up to four.
  EXPECT_LT(std::abs(found.inner_vertices[0].closure), 0.05 * degree);
  std::vector<double> truth, measured;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (!sheet.is_border(e)) truth.push_back(shape.angles[std::size_t(e)]);
  }
  for (const auto& crease : found.creases) measured.push_back(crease.fold_angle);
  std::sort(truth.begin(), truth.end());
  std::sort(measured.begin(), measured.end());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(measured[i], truth[i], 0.05 * degree);
  // Laid flat again, all four angles around the vertex are there: the sheet unfolds without a gap.
  const Sheet flat = unfolded_sheet(found.frame, "measured");
  EXPECT_EQ(flat.faces(), 4);
}

}  // namespace
}  // namespace hada
