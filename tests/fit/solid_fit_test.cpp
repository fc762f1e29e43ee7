#include "fit/solid_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(SolidFit, FindsTheStemThatSightingsWereTakenOf) {
  GrowthSolid truth;
  truth.frame.pith = {-2.0, 1.0};
  truth.lean = {0.02, -0.015};
  truth.taper = 0.01;
  truth.radii = {4.0, 6.0, 9.0, 11.0};
  truth.radii_loose.assign(4, 0.0);
  // Places on rings at two heights, off across them by 0.02 in each sighting.
  constexpr double noise = 0.02;
  std::vector<RingSighting> sightings;
  for (std::size_t face = 0; face < 2; ++face) {
    const double z = face == 0 ? 0.0 : 20.0;
    for (std::size_t ring = 0; ring < 4; ++ring) {
      for (int k = 0; k < 60; ++k) {
        const double turn = 2.0 * M_PI * k / 60.0;
        const double r = truth.radii[ring] - truth.taper * z +
                         noise * gaussian(11, std::int64_t(face), std::int64_t(ring), k);
        const Eigen::Vector2d pith = truth.frame.pith + truth.lean * z;
        sightings.push_back({{pith.x() + r * std::cos(turn), pith.y() + r * std::sin(turn), z},
                             face,
                             ring,
                             int(ring),
                             {std::cos(turn), std::sin(turn), 0.0}});
      }
    }
  }
  GrowthSolid start = truth;
  start.frame.pith = {-1.7, 0.8};
  start.lean = {0.0, 0.0};
  start.taper = 0.0;
  start.radii = {4.2, 6.1, 8.8, 11.1};
  const SolidFit fit = fitted_solid(sightings, start, {}, 2, 0.01);
  // 480 sightings: a mean over the half of them on one face is good to 0.02 / sqrt(120) on an axis,
  // a slope over 20 to a tenth of that; five times it, and the priors' pull.
  EXPECT_NEAR(fit.solid.frame.pith.x(), -2.0, 0.01);
  EXPECT_NEAR(fit.solid.frame.pith.y(), 1.0, 0.01);
  EXPECT_NEAR(fit.solid.lean.x(), 0.02, 0.001);
  EXPECT_NEAR(fit.solid.lean.y(), -0.015, 0.001);
  EXPECT_NEAR(fit.solid.taper, 0.01, 0.001);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fit.solid.radii[k], truth.radii[k], 0.02);
  ASSERT_EQ(fit.faces.size(), 2u);
  for (const FaceScatter& face : fit.faces) {
    EXPECT_EQ(face.sightings, 240);
    EXPECT_NEAR(face.scatter, noise, 0.2 * noise);  // a robust deviation of 240: 7 %
  }
}

}  // namespace
}  // namespace hada
