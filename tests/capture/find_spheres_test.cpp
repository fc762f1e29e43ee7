#include "capture/find_spheres.h"

#include <cmath>

#include <gtest/gtest.h>

#include "capture/sphere_geometry.h"
#include "core/error.h"
#include "table_scene.h"

namespace hada {
namespace {

TEST(FindSpheres, FindsBothKindsAndNothingElse) {
  const auto found = find_spheres(table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)}));
  ASSERT_EQ(found.spheres.size(), 2u);
  const Sphere& chrome = found.spheres[0];  // from left to right
  const Sphere& matte = found.spheres[1];
  EXPECT_EQ(chrome.kind, SphereKind::chrome);
  EXPECT_EQ(matte.kind, SphereKind::matte);
  // The picture's middle is (150, 100) px, a pixel 0.2 mm, y runs against v.
  EXPECT_LT((matte.center_px - Eigen::Vector2d(60.0, 55.0)).norm(), 0.3);
  EXPECT_NEAR(matte.radius_px, 25.0, 0.7);
  EXPECT_LT((chrome.center_px - Eigen::Vector2d(50.0, 145.0)).norm(), 0.6);
  EXPECT_NEAR(chrome.radius_px, 25.0, 0.8);
}

TEST(FindSpheres, FindsNoneWhereThereIsNone) {
  const auto found = find_spheres(table_scene({}));
  EXPECT_TRUE(found.spheres.empty());
}

TEST(FindSpheres, RejectsASphereThatTheFrameCutsOff) {
  const auto found = find_spheres(table_scene({matte_at(-28.0, 0.0)}));
  EXPECT_TRUE(found.spheres.empty());
  ASSERT_FALSE(found.rejected.empty());
  EXPECT_NE(found.rejected.front().find("cut off by the frame"), std::string::npos);
}

TEST(FindSpheres, TakesABoxAsAHintAndKeepsItsDiameter) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0), matte_at(-20.0, -9.0)});
  CaptureFile::SphereHint hint;
  hint.box = BoxPx{15, 110, 85, 180};
  hint.diameter_mm = 10.0;
  photographs.file.spheres = {hint};
  const auto found = find_spheres(photographs);
  ASSERT_EQ(found.spheres.size(), 1u);
  EXPECT_LT((found.spheres[0].center_px - Eigen::Vector2d(50.0, 145.0)).norm(), 0.5);
  EXPECT_EQ(found.spheres[0].diameter_mm, 10.0);
}

TEST(FindSpheres, SaysWhichBoxHoldsNoSphere) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0)});
  CaptureFile::SphereHint hint;
  hint.box = BoxPx{180, 60, 240, 120};
  photographs.file.spheres = {hint};
  try {
    find_spheres(photographs);
    FAIL() << "a box on the sheet was taken for a sphere";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("sphere box [180, 60, 240, 120] holds no sphere"),
              std::string::npos);
  }
}

TEST(FindSpheres, RefusesTwoBoxesAroundOneSphere) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0)});
  CaptureFile::SphereHint hint;
  hint.box = BoxPx{30, 25, 90, 85};
  photographs.file.spheres = {hint, hint};
  try {
    find_spheres(photographs);
    FAIL() << "one sphere was counted twice";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("holds the same sphere as another box"),
              std::string::npos);
  }
}

TEST(FindSpheres, SeesTheOutlineOfASmallMirror) {
  for (const bool known : {false, true}) {
    Photographs photographs = table_scene({chrome_at(-18.0, 9.0, 4.0)});
    CaptureFile::SphereHint hint;
    hint.kind = SphereKind::chrome;
    if (known) hint.diameter_mm = 4.0;
    photographs.file.spheres = {hint};
    const auto found = find_spheres(photographs);
    ASSERT_EQ(found.spheres.size(), 1u);
    const Sphere& sphere = found.spheres[0];
    if (known) {
      EXPECT_NEAR(sphere.radius_px, 10.0, 1e-6);
    } else {
      EXPECT_LT(std::abs(sphere.radius_px - 10.0), 3.0 * sphere.sigma_px);
    }
    EXPECT_LT((sphere.center_px - Eigen::Vector2d(60.0, 55.0)).norm(), 3.0 * sphere.sigma_px);
  }
}

Mask disc_mask(const Extent& extent, const Eigen::Vector2d& center, double radius) {
  Mask mask(extent.rows, extent.cols, 0);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      mask(row, col) = (Eigen::Vector2d(col + 0.5, row + 0.5) - center).norm() < radius;
    }
  }
  return mask;
}

TEST(FindSpheres, LooksBesideARoundMask) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  photographs.mask = disc_mask(photographs.camera.extent, {210.0, 100.0}, 50.0);
  const auto found = find_spheres(photographs);
  ASSERT_EQ(found.spheres.size(), 2u);
  EXPECT_LT((found.spheres[1].center_px - Eigen::Vector2d(60.0, 55.0)).norm(), 0.3);
}

TEST(FindSpheres, BelievesTheMaskOfASphereAlone) {
  Photographs photographs = table_scene({chrome_at(-18.0, 0.0, 12.0)});
  photographs.mask = disc_mask(photographs.camera.extent, {60.0, 100.0}, 30.0);
  const auto found = find_spheres(photographs);
  ASSERT_EQ(found.spheres.size(), 1u);
  EXPECT_EQ(found.spheres[0].kind, SphereKind::chrome);
  EXPECT_LT((found.spheres[0].center_px - Eigen::Vector2d(60.0, 100.0)).norm(), 0.01);
  EXPECT_NEAR(found.spheres[0].radius_px, 30.0, 0.1);
}

// Half of the rim before a bright wall, the other before black cloth, and a mask a pixel too low.
TEST(FindSpheres, KnowsAClearOutlineBetterThanAMask) {
  Photographs photographs = table_scene({chrome_at(-10.0, 0.0, 20.0)});
  const Eigen::Vector2d center(100.0, 100.0);
  for (std::size_t k = 0; k < photographs.images.size(); ++k) {
    Grid<float>& plane = photographs.images[k].planes[0];
    for (int row = 0; row < plane.rows(); ++row) {
      for (int col = 0; col < plane.cols(); ++col) {
        const double r = (Eigen::Vector2d(col + 0.5, row + 0.5) - center).norm();
        const double outside = std::clamp(r - 49.5, 0.0, 1.0);
        const double spot = (Eigen::Vector2d(col - 90.0 - 3.0 * double(k), row - 90.0)).norm();
        const double inside = spot < 2.0 ? 0.8 : 0.002;
        plane(row, col) = float((1.0 - outside) * inside + outside * (row < 110 ? 0.01 : 0.002));
      }
    }
  }
  photographs.mask = disc_mask(photographs.camera.extent, {100.0, 101.0}, 50.5);
  const auto found = find_spheres(photographs);
  ASSERT_EQ(found.spheres.size(), 1u);
  EXPECT_EQ(found.spheres[0].kind, SphereKind::chrome);
  EXPECT_LT((found.spheres[0].center_px - center).norm(), 0.1);
  // On a logarithm the middle of a step of a factor of five lies where 31 % of a pixel are wall:
  // 0.19 px further in.
  EXPECT_NEAR(found.spheres[0].radius_px, 49.81, 0.1);
}

}  // namespace
}  // namespace hada
