#include "reconstruct/integrate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/camera.h"
#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/regions.h"
#include "scenes.h"

namespace hada {
namespace {

TEST(Integrate, ReturnsATiltedPlane) {
  const Relief plane = relief_of(
      40, 60, [](double x, double y) { return Eigen::Vector3d(0.3 * x - 0.2 * y, 0.3, -0.2); });
  const Mask mask = full_mask(plane.extent);
  // Normals are floats: slopes are off by 6e-8, the same everywhere, over 36 px to the corner.
  EXPECT_LT(rms_difference(integrate(plane.normals, mask, 1.0), plane.height, mask), 5e-6);
}

TEST(Integrate, IsExactForAQuadraticSurface) {
  const Relief bowl = relief_of(50, 50, [](double x, double y) {
    return Eigen::Vector3d(0.01 * x * x - 0.02 * x * y + 0.005 * y * y, 0.02 * x - 0.02 * y,
                           -0.02 * x + 0.01 * y);
  });
  const Mask mask = full_mask(bowl.extent);
  // Only the rounding of the normals (6e-8 of slopes up to 1) and of heights up to 20 is left.
  EXPECT_LT(rms_difference(integrate(bowl.normals, mask, 1.0), bowl.height, mask), 1e-5);
}

TEST(Integrate, ReturnsTheSphericalCapItCameFrom) {
  constexpr double radius = 120.0;
  const Relief cap = relief_of(100, 100, [](double x, double y) {
    const double z = std::sqrt(radius * radius - x * x - y * y);
    return Eigen::Vector3d(z, -x / z, -y / z);
  });
  const Mask mask = full_mask(cap.extent);
  // A trapezoidal step errs by z''' / 12; along a path from the centre to x these add up to
  // (z''(x) - z''(0)) / 12, and z'' goes from -1 / radius to about -3 / radius at the corner.
  EXPECT_LT(rms_difference(integrate(cap.normals, mask, 1.0), cap.height, mask),
            2.0 / (12.0 * radius));
}

TEST(Integrate, GivesTheHeightInTheUnitOfThePitch) {
  const Relief relief = waves(30, 40);
  const Mask mask = full_mask(relief.extent);
  const auto pixels = integrate(relief.normals, mask, 1.0);
  const auto millimetres = integrate(relief.normals, mask, 0.25);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_NEAR(millimetres[i], 0.25f * pixels[i], 1e-6f);
  }
}

TEST(Integrate, UndoesPerspective) {
  // A sphere that touches the table from below, met by the ray through every pixel.
  const double distance = 300.0;
  const double radius = 150.0;
  const double pitch = 0.5;
  const Camera camera{.extent = {.rows = 160, .cols = 200, .pitch = pitch},
                      .model = Camera::Model::perspective,
                      .focal_px = distance / pitch};
  Grid<double> height(160, 200);
  NormalMap normals(160, 200, Eigen::Vector3f::UnitZ());
  const Eigen::Vector3d middle(0.0, 0.0, -radius);
  for (int row = 0; row < 160; ++row) {
    for (int col = 0; col < 200; ++col) {
      const Ray ray = camera.ray(col + 0.5, row + 0.5);
      const Eigen::Vector3d to = ray.origin - middle;
      const double along = -to.dot(ray.direction);
      const double t = along - std::sqrt(along * along - to.squaredNorm() + radius * radius);
      height(row, col) = ray.origin.z() + t * ray.direction.z();
      normals(row, col) = ((to + t * ray.direction) / radius).cast<float>();
    }
  }
  // A part off the axis. The true scene is scaled about the pin-hole to a mean log depth of zero.
  const NormalMap part = crop(normals, 20, 30, 120, 150);
  Grid<double> truth = crop(height, 20, 30, 120, 150);
  double mean = 0.0;
  for (const double z : truth) mean += std::log(1.0 - z / distance) / double(truth.size());
  for (double& z : truth) z = distance - (distance - z) / std::exp(mean);
  const Mask mask(120, 150, 1);
  const auto found = integrate(part, mask, pitch, {.pin_hole = pin_hole_of(camera, {30, 20})});
  // Trapezoidal steps err, added up, by the change of pitch^2 / 12 times the second derivative of
  // w; which is about -1 / radius, twice that in the corner.
  const double steps = pitch * pitch / 12.0 / radius;
  EXPECT_LT(rms_difference(found, truth, mask), steps);
  // What it is good for:
  EXPECT_GT(rms_difference(integrate(part, mask, pitch), truth, mask), 100.0 * steps);
}

TEST(Integrate, AgreesWithPlainConjugateGradientsOnTornMasks) {
  for (Seed seed = 1; seed <= 3; ++seed) {
    const Mask mask = torn_mask(90, 110, seed);
    Relief relief = waves(90, 110);
    for (std::size_t i = 0; i < relief.normals.size(); ++i) {  // slopes that no surface has
      const auto key = std::int64_t(i);
      const Eigen::Vector3f noise(float(0.1 * gaussian(seed, key, 1)),
                                  float(0.1 * gaussian(seed, key, 2)), 0.0f);
      relief.normals[i] = (relief.normals[i] + noise).normalized();
    }
    const auto fast = integrate(relief.normals, mask, 1.0, {.tolerance_px = 1e-6});
    const auto reference = integrate_reference(relief.normals, mask, 1.0);
    // The contract. The estimate of the error may be off by a factor of a few.
    EXPECT_LT(rms_difference(fast, reference, mask), 5e-6) << "seed " << seed;
  }
}

TEST(Integrate, LevelsEachRegionOnItsOwn) {
  const Mask mask = torn_mask(90, 110, 4);
  const Regions regions = regions_of(mask);
  ASSERT_GT(regions.size.size(), 4u);
  const auto height = integrate(waves(90, 110).normals, mask, 1.0);
  std::vector<double> sum(regions.size.size(), 0.0);
  for (int row = 0; row < height.rows(); ++row) {
    for (int col = 0; col < height.cols(); ++col) {
      sum[std::size_t(regions.label(row, col))] += height(row, col);
    }
  }
  EXPECT_EQ(sum[0], 0.0);  // outside the mask
  for (std::size_t region = 1; region < sum.size(); ++region) {
    // Each height (up to 4 px) is rounded to a float: 2.4e-7 at most.
    EXPECT_NEAR(sum[region] / regions.size[region], 0.0, 2.4e-7);
    if (regions.size[region] == 1) {
      EXPECT_EQ(sum[region], 0.0);
    }
  }
}

TEST(Integrate, DoesNotReadOutsideTheMask) {
  Relief relief = waves(40, 40);
  const Mask mask = torn_mask(40, 40, 5);
  const auto height = integrate(relief.normals, mask, 1.0);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) relief.normals[i] = Eigen::Vector3f::Constant(std::nanf(""));
  }
  EXPECT_EQ(integrate(relief.normals, mask, 1.0), height);
}

TEST(Integrate, GivesTheSameBytesAtAnyThreadCount) {
  const Relief relief = waves(640, 900);  // large enough to be shared out among threads
  const Mask mask = torn_mask(640, 900, 6);
  set_threads(1);
  const auto one = integrate(relief.normals, mask, 1.0);
  set_threads(2);
  const auto two = integrate(relief.normals, mask, 1.0);
  set_threads(0);
  EXPECT_EQ(one, two);
}

// A ramp beside a plain: along y = 0 there is a jump that begins at nothing and grows to 30 px.
Relief ramp_beside_a_plain() {
  return relief_of(120, 120, [](double x, double y) {
    const double t = std::max((x + 30.0) / 90.0, 0.0);
    if (y < 0.0) return Eigen::Vector3d(0.0, 0.0, 0.0);
    return Eigen::Vector3d(30.0 * t * t, 60.0 * t / 90.0, 0.0);
  });
}

TEST(IntegrateWithJumps, FindsTheJumpWhereTheSurfaceHidesAPartOfItself) {
  const Relief ramp = ramp_beside_a_plain();
  const Mask mask(120, 120, 1);
  const auto found = integrate_with_jumps(ramp.normals, mask, 1.0, Jumps::automatic);
  EXPECT_TRUE(found.may_jump) << found.reason;
  const double smooth = rms_difference(integrate(ramp.normals, mask, 1.0), ramp.height, mask);
  // Its foot, where the jump is no steeper than the slopes beside it, stays a slope and tilts the
  // rest.
  EXPECT_LT(rms_difference(found.height, ramp.height, mask), smooth / 4.0);
}

TEST(IntegrateWithJumps, StaysWithLeastSquaresOnASmoothSurfaceWithNoise) {
  Relief relief = waves(80, 90);
  for (std::size_t i = 0; i < relief.normals.size(); ++i) {
    const auto key = std::int64_t(i);
    relief.normals[i] +=
        Eigen::Vector3f(float(0.1 * gaussian(4, key, 1)), float(0.1 * gaussian(4, key, 2)), 0.0f);
    relief.normals[i].normalize();
  }
  const Mask mask = torn_mask(80, 90, 1);
  const auto found = integrate_with_jumps(relief.normals, mask, 1.0, Jumps::automatic);
  EXPECT_FALSE(found.may_jump);
  EXPECT_EQ(found.height, integrate(relief.normals, mask, 1.0));
}

TEST(Integrate, BelievesPixelsAsTheirWeightsSay) {
  // One stripe of normals is wrong; with a weight of 1e-6 it bends the height no more.
  Relief relief = waves(60, 60);
  IntegrateOptions options;
  options.weight = Grid<float>(60, 60, 1.0f);
  const Mask mask(60, 60, 1);
  const auto truth = integrate(relief.normals, mask, 1.0);
  for (int row = 20; row < 40; ++row) {
    for (int col = 28; col < 31; ++col) {
      relief.normals(row, col) = Eigen::Vector3f(0.6f, 0.0f, 0.8f);
      options.weight(row, col) = 1e-6f;
    }
  }
  EXPECT_GT(rms_difference(integrate(relief.normals, mask, 1.0), truth, mask), 0.1);
  Mask good = mask;
  for (int row = 19; row < 41; ++row) {
    for (int col = 27; col < 32; ++col) good(row, col) = 0;
  }
  // What the stripe would have said of the waves is missing, which is little around it.
  EXPECT_LT(rms_difference(integrate(relief.normals, mask, 1.0, options), truth, good), 0.02);
}

TEST(Integrate, RefusesAnEmptyMask) {
  EXPECT_THROW(integrate(NormalMap(3, 3, Eigen::Vector3f::UnitZ()), Mask(3, 3, 0), 1.0), Error);
}

TEST(Integrate, LeavesASinglePixelAtZero) {
  EXPECT_EQ(integrate(NormalMap(1, 1, Eigen::Vector3f(0.6f, 0.0f, 0.8f)), Mask(1, 1, 1), 1.0)(0, 0),
            0.0f);
}

}  // namespace
}  // namespace hada
