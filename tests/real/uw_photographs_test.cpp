#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"

namespace hada {
namespace {

TEST(UwPhotographs, ChromeAndGreySphereAgreeOnTheLights) {
  if (!std::filesystem::exists(data_folder() / "photos" / "uw")) {
    GTEST_SKIP() << "the photographs are not in " << data_folder();
  }
  // 1.9 degrees is what two independent estimates of these pictures differ by.
  EXPECT_LT(sphere_agreement(data_folder()).mean_deg, 2.0);
}

TEST(UwPhotographs, BuddhaIsReconstructedWhole) {
  if (!std::filesystem::exists(data_folder() / "photos" / "uw")) {
    GTEST_SKIP() << "the photographs are not in " << data_folder();
  }
  const RelightingScore score = relighting(data_folder(), "buddha");
  EXPECT_GT(score.pixels, 0.95);
  // A matte statue with cast shadows: an eighth of its brightness at most is not Lambertian.
  EXPECT_LT(score.relighting_error, 0.125);
}

}  // namespace
}  // namespace hada
