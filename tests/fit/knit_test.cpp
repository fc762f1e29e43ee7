#include "fit/knit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/knit_loops.h"

namespace hada {
namespace {

/// A photograph of `knit`: rendered twice as fine, shaded by a light, with uneven stitches, noise
/// and eight bits.
Surface photographed(const Knit<>& knit, const Extent& extent, Seed seed, double jitter_mm) {
  const Extent fine{2 * extent.rows, 2 * extent.cols, 0.5 * extent.pitch, extent.unit};
  const auto maps = knit_maps(knit, fine, seed, {.jitter_mm = jitter_mm});
  const Eigen::Vector3f light = Eigen::Vector3f(-0.2f, 0.3f, 0.9f).normalized();
  Surface seen;
  seen.extent = extent;
  seen.mask = full_mask(extent);
  seen.albedo = Image(extent.rows, extent.cols, 3);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      Eigen::Vector3f sum = Eigen::Vector3f::Constant(0.02f);
      for (int k = 0; k < 4; ++k) {
        const int r = 2 * row + k / 2, c = 2 * col + k % 2;
        if (maps.course(r, c) < 0) continue;
        const auto& yarn =
            knit.yarns[std::size_t(knit.colour_repeat[std::size_t(maps.course(r, c))])];
        const float shade = 0.3f + 0.7f * std::max(0.0f, maps.normals(r, c).dot(light));
        sum += 0.25f * shade * Eigen::Vector3d(yarn.red, yarn.green, yarn.blue).cast<float>();
      }
      for (int c = 0; c < 3; ++c) {
        const double noisy = sum[c] + 0.02 * gaussian(seed + 1, row, col, c);
        seen.albedo.planes[std::size_t(c)](row, col) =
            float(std::round(255.0 * std::clamp(noisy, 0.0, 1.0)) / 255.0);
      }
    }
  }
  return seen;
}

Knit<> striped() {
  Knit<> knit;
  knit.wale_mm = 1.83;
  knit.course_mm = 1.41;
  knit.rotation_rad = -0.08;
  knit.skew_rad = 0.03;
  knit.wale_gradient_per_mm = 0.0008;
  knit.course_gradient_per_mm = -0.0006;
  knit.wale_phase = 0.3;
  knit.course_phase = 0.2;
  knit.yarn_radius_mm = 0.31;
  knit.loop_depth_mm = 0.25;
  knit.colour_repeat = {0.0, 1.0, 1.0};
  knit.yarns = {{0.15, 0.25, 0.4}, {0.7, 0.6, 0.3}};
  return knit;
}

TEST(FitKnit, FindsAStripedKnitInAPhotograph) {
  const Knit<> truth = striped();
  const auto fit = fit_knit(photographed(truth, {420, 540, 0.07, Unit::mm}, 5, 0.02));
  const Knit<>& found = fit.material;
  // Lattice: five of its sigmas, which are a ten-thousandth of the spacings and themselves known
  // to a tenth. The loop is the mean of 400 stitches: what remains are the pixels of the mean
  // stitch, a 32nd of a wale wide, of which edges are found to a fifth.
  EXPECT_NEAR(found.wale_mm, truth.wale_mm, 5.0 * fit.sigma.wale_mm);
  EXPECT_NEAR(found.course_mm, truth.course_mm, 5.0 * fit.sigma.course_mm);
  EXPECT_NEAR(found.rotation_rad, truth.rotation_rad, 5.0 * fit.sigma.rotation_rad);
  EXPECT_NEAR(found.skew_rad, truth.skew_rad, 5.0 * fit.sigma.skew_rad);
  EXPECT_NEAR(found.wale_gradient_per_mm, truth.wale_gradient_per_mm,
              5.0 * fit.sigma.wale_gradient_per_mm);
  EXPECT_NEAR(found.course_gradient_per_mm, truth.course_gradient_per_mm,
              5.0 * fit.sigma.course_gradient_per_mm);
  EXPECT_LT(fit.sigma.wale_mm, 3e-4 * truth.wale_mm);
  EXPECT_LT(fit.sigma.course_mm, 3e-4 * truth.course_mm);
  EXPECT_NEAR(found.yarn_radius_mm, truth.yarn_radius_mm, truth.wale_mm / 32.0 / 5.0);
  EXPECT_EQ(found.colour_repeat, truth.colour_repeat);
  EXPECT_NEAR(found.course_phase, truth.course_phase, 0.05);
}

TEST(FitKnit, NeedsNoColoursAndNoUnit) {
  Knit<> truth = striped();
  truth.wale_mm = 17.0;
  truth.course_mm = 14.2;
  truth.yarn_radius_mm = 2.9;
  truth.loop_depth_mm = 2.3;
  truth.wale_gradient_per_mm = truth.course_gradient_per_mm = 0.0;
  truth.colour_repeat = {0.0};
  truth.yarns = {{0.4, 0.4, 0.4}};
  const auto fit = fit_knit(photographed(truth, {300, 300, 1.0, Unit::px}, 6, 0.2));
  EXPECT_NEAR(fit.material.wale_mm, truth.wale_mm, 5.0 * fit.sigma.wale_mm);
  EXPECT_NEAR(fit.material.course_mm, truth.course_mm, 5.0 * fit.sigma.course_mm);
  EXPECT_EQ(fit.material.colour_repeat, truth.colour_repeat);
}

TEST(FitKnit, RefusesWhatIsNoKnit) {
  Surface even;
  even.extent = {64, 64, 1.0, Unit::px};
  even.mask = full_mask(even.extent);
  even.albedo = Image(Grid<float>(64, 64, 0.5f));
  EXPECT_THROW(fit_knit(even), Error);
}

}  // namespace
}  // namespace hada
