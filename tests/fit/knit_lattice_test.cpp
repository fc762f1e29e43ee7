#include "fit/knit_lattice.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

TEST(KnitLattice, IsFoundFromAGuessThatIsOff) {
  Knit<> knit;
  knit.wale_mm = 1.5;
  knit.course_mm = 1.2;
  knit.rotation_rad = 0.02;
  auto surface = synthesize(knit, {320, 320, 0.08, Unit::mm}, 3);
  // One yarn is of one colour: it is seen by its shading, holes are black.
  const Eigen::Vector3f light = Eigen::Vector3f(-0.2f, 0.3f, 0.9f).normalized();
  Grid<float> shade(320, 320);
  for (std::size_t i = 0; i < shade.size(); ++i) {
    if (surface.mask[i]) shade[i] = std::max(0.0f, surface.normals[i].dot(light));
  }
  surface.albedo = Image(shade);
  surface.mask = full_mask(surface.extent);
  Knit<> guess = knit;
  guess.wale_mm *= 1.01;
  guess.course_mm *= 0.99;
  guess.rotation_rad = 0.01;
  const auto fit = fit_lattice(knit_picture(surface, 1.2, 10.0), guess);
  EXPECT_FALSE(fit.wanders);
  EXPECT_GT(fit.explained, 0.6);
  // A made knit tiles: 17 wales and 21 courses share its 25.6 mm, and nothing is turned. The rest
  // is what a made picture must allow.
  EXPECT_NEAR(fit.knit.wale_mm / (25.6 / 17), 1.0, 1e-3);
  EXPECT_NEAR(fit.knit.course_mm / (25.6 / 21), 1.0, 1e-3);
  EXPECT_NEAR(fit.knit.rotation_rad, 0.0, 1e-3);
  for (int k = 0; k < lattice_field_count; ++k) EXPECT_GT(fit.covariance(k, k), 0.0);
}

}  // namespace
}  // namespace hada
