#include "fit/wood.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

/// A stem whose rings have the widths that nature gives them.
Wood<> stem(double x_mm, double y_mm, double reach_mm, Seed seed) {
  Wood<> wood;
  wood.pith_mm = {x_mm, y_mm};
  wood.lobes = {{2.0, 0.02, -0.03}, {3.0, 0.008, 0.006}};
  wood.fibre_shift = 0.15;
  wood.fibre_mm = 0.12;
  wood.ring_radii_mm.clear();
  double radius = 0.0, width = 2.0;
  for (int k = 0; radius < reach_mm; ++k) {
    width = std::exp(std::log(2.0) + 0.6 * std::log(width / 2.0) + 0.25 * gaussian(seed, k));
    radius += std::max(width, 0.9);
    wood.ring_radii_mm.push_back(radius);
  }
  return wood;
}

/// The cut drawn three times finer than it is looked at, with noise and 8 bits.
Surface picture(const Wood<>& wood, int rows, int cols, double pitch, Seed seed) {
  constexpr int finer = 3;
  const auto fine =
      synthesize(wood, {finer * rows, finer * cols, pitch / finer, Unit::mm}, seed).albedo;
  Surface surface;
  surface.extent = {rows, cols, pitch, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = Image(rows, cols, 3);
  for (int c = 0; c < 3; ++c) {
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        double sum = 0.0;
        for (int k = 0; k < finer * finer; ++k)
          sum +=
              double(fine.planes[std::size_t(c)](finer * row + k / finer, finer * col + k % finer));
        const double noisy = sum / (finer * finer) + 0.01 * gaussian(seed + 50, row, col, c);
        surface.albedo.planes[std::size_t(c)](row, col) =
            float(std::round(255.0 * std::clamp(noisy, 0.0, 1.0)) / 255.0);
      }
    }
  }
  return surface;
}

/// The radii of `wood` that run through the picture, a pixel and a half clear of its corners: an
/// edge nearer than its smoothing reaches is not seen.
std::vector<double> visible(const Wood<>& wood, const Extent& extent) {
  double least = HUGE_VAL, most = 0.0;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d arm =
          extent.place(row, col) - Eigen::Vector2d(wood.pith_mm[0], wood.pith_mm[1]);
      const double rho = effective_radius(wood.lobes, arm.norm(), std::atan2(arm.y(), arm.x()));
      least = std::min(least, rho);
      most = std::max(most, rho);
    }
  }
  std::vector<double> radii;
  for (const double radius : wood.ring_radii_mm) {
    if (radius > least + 8.0 * extent.pitch && radius < most - 8.0 * extent.pitch)
      radii.push_back(radius);
  }
  return radii;
}

/// Every visible ring is found once, within `tolerance`.
void expect_rings(const std::vector<double>& found, const std::vector<double>& truth,
                  double tolerance) {
  for (const double radius : truth) {
    int near = 0;
    for (const double candidate : found) near += std::abs(candidate - radius) < tolerance ? 1 : 0;
    EXPECT_EQ(near, 1) << radius;
  }
  EXPECT_LE(found.size(), truth.size() + 2u);  // one at each end may show in a corner
}

TEST(FitWood, FindsPithAndRingsInThePicture) {
  const auto wood = stem(3.0, -4.0, 40.0, 1);
  const auto surface = picture(wood, 360, 400, 0.12, 2);
  const auto fit = fit_wood(surface);
  // Some 500 edge points of 0.2 px each fix the pith to a few hundredths of a pixel, 0.12 mm wide.
  EXPECT_NEAR(fit.material.pith_mm[0], 3.0, 0.012);
  EXPECT_NEAR(fit.material.pith_mm[1], -4.0, 0.012);
  expect_rings(fit.material.ring_radii_mm, visible(wood, surface.extent), 0.5 * 0.12);
  EXPECT_NEAR(fit.material.lobes[0].cosine, 0.02, 1e-3);
  EXPECT_NEAR(fit.material.lobes[0].sine, -0.03, 1e-3);
}

TEST(FitWood, FindsAPithOutsideThePicture) {
  const auto wood = stem(-38.0, 14.0, 90.0, 3);
  const auto surface = picture(wood, 330, 380, 0.12, 4);
  const auto fit = fit_wood(surface);
  const double sigma = std::hypot(fit.sigma.pith_mm[0], fit.sigma.pith_mm[1]);
  EXPECT_LT(std::hypot(fit.material.pith_mm[0] + 38.0, fit.material.pith_mm[1] - 14.0),
            4.0 * sigma + 0.012);
  EXPECT_LT(sigma, 0.5);
}

TEST(FitWood, ReadsHowARingDarkens) {
  const auto wood = stem(0.0, 0.0, 30.0, 5);
  const auto fit = fit_wood(picture(wood, 300, 300, 0.12, 6));
  EXPECT_NEAR(fit.material.latewood_share, wood.latewood_share, 3.0 * fit.sigma.latewood_share);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(fit.material.early_rgb[c], wood.early_rgb[c], 0.01);  // one level of noise
    EXPECT_NEAR(fit.material.late_rgb[c], wood.late_rgb[c], 3.0 * fit.sigma.late_rgb[c] + 0.01);
  }
}

TEST(FitWood, LeavesOutTheGroundAroundADisc) {
  const auto wood = stem(1.0, 2.0, 30.0, 7);
  auto surface = picture(wood, 320, 320, 0.12, 8);
  for (int row = 0; row < 320; ++row) {
    for (int col = 0; col < 320; ++col) {
      if (surface.extent.place(row, col).norm() < 16.0) continue;
      for (auto& plane : surface.albedo.planes) plane(row, col) = 1.0f;
    }
  }
  const auto fit = fit_wood(surface);
  EXPECT_NEAR(fit.material.pith_mm[0], 1.0, 0.03);
  EXPECT_NEAR(fit.material.pith_mm[1], 2.0, 0.03);
  EXPECT_LT(fit.material.ring_radii_mm.back(), 18.5);  // the border of the disc is no ring
}

TEST(FitWood, RefusesWhatHasNoRings) {
  Surface surface;
  surface.extent = {64, 64, 0.2, Unit::mm};
  surface.mask = full_mask(surface.extent);
  EXPECT_THROW(fit_wood(surface), Error);  // no albedo
  surface.albedo = Image(Grid<float>(64, 64, 0.5f));
  EXPECT_THROW(fit_wood(surface), Error);  // nothing on it
}

}  // namespace
}  // namespace hada
