#include "fit/faces_left_out.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "fit/ripple_prior.h"

namespace hada {
namespace {

/// Places on the rings of a stem whose ripples are `times` as high as `prior` takes them for, on
/// five faces.
double surprise(double times) {
  GrowthSolid start;
  start.frame.pith = {0.0, -400.0};
  for (int k = 0; k < 6; ++k) start.radii.push_back(330.0 + 22.0 * k);
  start.ripples = ripples_in({{-130, -130, -130}, {260, 260, 260}}, 60);
  SolidPrior prior{.pith = 1.0, .lean = 1e-3, .taper = 1e-3};
  prior.ripples = wave_sigma(start.ripples, {.height = 2.0, .across = 60.0, .along = 60.0});
  GrowthSolid truth = start;
  for (std::size_t n = 0; n < prior.ripples.size(); ++n)
    truth.ripples.heights[n] = times * prior.ripples[n] * gaussian(5, std::int64_t(n));
  std::vector<RingSighting> sightings;
  for (std::size_t face = 0; face < 5; ++face) {
    const double z = -100.0 + 50.0 * double(face);
    for (std::size_t ring = 0; ring < 6; ++ring) {
      for (double x = -100.0; x <= 100.0; x += 10.0) {
        RingSighting seen{{x, start.radii[ring] - 400.0, z}, face, ring, int(ring), {0, 1, 0}};
        for (int round = 0; round < 5; ++round)
          seen.place[1] += start.radii[ring] - local_of(truth, seen.place, false).rho;
        seen.place[1] += 0.05 * gaussian(6, std::int64_t(face), std::int64_t(ring), int(x));
        sightings.push_back(seen);
      }
    }
  }
  const std::vector<FaceScatter> faces(5, {.scatter = 0.05, .effect = 1.0, .sightings = 126});
  return surprise_of_faces(sightings, {}, start, prior, faces, 0.05);
}

TEST(FacesLeftOut, TellHowMuchHigherRipplesAreThanTheyWereTakenFor) {
  // As high as they were taken for: 1, and 2.132 / 1.645 = 1.30 for five faces; as so few places
  // know it, to a third.
  EXPECT_NEAR(surprise(1.0), 1.3, 0.45);
  EXPECT_NEAR(surprise(3.0) / surprise(1.0), 3.0, 0.5);
}

TEST(FacesLeftOut, SayNothingOfOneFace) {
  EXPECT_EQ(surprise_of_faces({}, {}, {}, {}, {{}}, 0.1), 1.0);
}

}  // namespace
}  // namespace hada
