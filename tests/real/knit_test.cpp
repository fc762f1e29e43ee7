#include "fit/knit.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"
#include "io/surface_file.h"
#include "measure/lattice.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

struct Rendered {
  const char* file;
  double pixel_mm, wale_mm, course_mm, rotation_deg, radius_mm, wale_gradient, course_gradient;
  std::vector<double> repeat;
};

TEST(RealKnit, IsMeasuredInRenderedPictures) {
  const fs::path folder = data_folder() / "rendered" / "knit_flat";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not here";
  for (const Rendered& truth :
       {Rendered{"coarse_a.png", 0.055, 2.6693, 2.1586, 2.98, 0.5, 0.00035, -0.0004, {1, 0}},
        Rendered{"fine_b.png", 0.04, 1.4782, 1.1221, -4.21, 0.225, -0.0009, 0.0007, {0, 0, 1}}}) {
    const auto found = fit_knit(read_surface(folder / truth.file, truth.pixel_mm)).material;
    // What is asked for of these pictures.
    EXPECT_NEAR(found.wale_mm / truth.wale_mm, 1.0, 0.002);
    EXPECT_NEAR(found.course_mm / truth.course_mm, 1.0, 0.002);
    EXPECT_NEAR(found.rotation_rad * 180.0 / M_PI, truth.rotation_deg, 0.05);
    EXPECT_NEAR(found.yarn_radius_mm / truth.radius_mm, 1.0, 0.05);
    EXPECT_NEAR(found.wale_gradient_per_mm / truth.wale_gradient, 1.0, 0.1);
    EXPECT_NEAR(found.course_gradient_per_mm / truth.course_gradient, 1.0, 0.1);
    EXPECT_EQ(found.colour_repeat, truth.repeat);
  }
}

TEST(RealKnit, IsCountedInAPhotographOfHandKnit) {
  const fs::path file = data_folder() / "knit" / "whichstitch_stockinette.jpg";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const auto found = fit_knit(read_surface(file)).material;
  constexpr double width_px = 253.0;
  EXPECT_NEAR(width_px / found.wale_mm / 14.2, 1.0, 0.005);
  EXPECT_NEAR(width_px / found.course_mm / 22.0, 1.0, 0.005);
}

TEST(RealKnit, HasTheExactPeaksOfATexture) {
  const fs::path file =
      data_folder() / "knit" / "jersey_authored" / "Fabric_Knitted_006_height.png";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const Surface surface = read_surface(file);
  const auto spectrum =
      power_spectrum(luminance(surface.albedo), surface.mask, surface.extent, {.taper = 1.0});
  const auto peaks = spectral_peaks(spectrum);
  for (const Eigen::Vector2d& wanted : {Eigen::Vector2d(32.0, 64.0), Eigen::Vector2d(64.0, 0.0)}) {
    double nearest = 1e9;
    for (const auto& peak : peaks) {
      nearest = std::min(nearest, (peak.frequency * surface.extent.width() - wanted).norm());
    }
    EXPECT_LT(nearest, 0.005);
  }
}

}  // namespace
}  // namespace hada
