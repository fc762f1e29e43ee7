#include "capture/calibrate.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/image_file.h"
#include "table_scene.h"

namespace hada {
namespace {

double mean_error_deg(const std::vector<Light>& found, const std::vector<Light>& truth) {
  double sum = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    sum += angle_deg(found[k].direction, truth[k].direction) / double(truth.size());
  }
  return sum;
}

TEST(Calibrate, ReadsTheLightsOffAMatteSphere) {
  const Calibration calibration = calibrate(table_scene({matte_at(-18.0, 0.0)}));
  const auto truth = six_lights();
  ASSERT_EQ(calibration.lights.size(), truth.size());
  // An outline known to 0.1 px of 25 tilts every light by 0.23 degrees.
  EXPECT_LT(mean_error_deg(calibration.lights, truth), 0.3);
  double mean = 0.0;
  for (const Light& light : truth) mean += light.strength[0] / double(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_NEAR(calibration.lights[k].strength[0], truth[k].strength[0] / mean, 0.01);
  }
}

TEST(Calibrate, ReadsTheLightsOffAChromeSphere) {
  const Calibration calibration = calibrate(table_scene({chrome_at(-18.0, 0.0, 12.0)}));
  // The spot is smaller than a pixel and clips, so it is known to 0.3 px, and the mirror doubles
  // the angle: 2 * 0.3 / 30 = 1.15 degrees.
  EXPECT_LT(mean_error_deg(calibration.lights, six_lights()), 1.15);
}

TEST(Calibrate, KnowsHowStrongColouredLampsAreOverAColouredSheet) {
  auto rig = table_rig({matte_at(-18.0, 0.0)});
  for (std::size_t k = 0; k < rig.lights.size(); ++k) {
    Eigen::Vector3d& strength = rig.lights[k].strength;
    strength = strength.cwiseProduct(k % 2 == 0 ? Eigen::Vector3d(1.2, 0.7, 0.5)
                                                : Eigen::Vector3d(0.8, 0.9, 1.1));
  }
  Surface sheet = waved_sheet(24.0);
  const Grid<float> white = sheet.albedo.planes[0];
  sheet.albedo = Image(white.rows(), white.cols(), 3);
  const float colour[3] = {1.0f, 0.8f, 0.4f};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < white.size(); ++i) {
      sheet.albedo.planes[c][i] = colour[c] * white[i];
    }
  }
  const Calibration found = calibrate(photographs_of(photograph(sheet, rig)));
  // Over some 2000 pixels of 1 % noise and 16 bits strengths are known to 0.05 %; were the sheet
  // weighed in other colours than the sphere, they would differ by 3 % from lamp to lamp.
  for (int c = 0; c < 3; ++c) {
    const auto gauge = [&](std::size_t k) {
      return found.lights[k].strength[c] / rig.lights[k].strength[c];
    };
    for (std::size_t k = 1; k < 6; ++k) EXPECT_NEAR(gauge(k) / gauge(0), 1.0, 0.002);
  }
}

TEST(Calibrate, ReportsHowMuchTheSpheresDisagree) {
  const Calibration calibration =
      calibrate(table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)}));
  ASSERT_EQ(calibration.readings.size(), 2u);
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    sum += angle_deg(calibration.readings[0].lights[k].direction,
                     calibration.readings[1].lights[k].direction);
  }
  // Distant lights look the same from both places. A chord is shorter than its arc: by 4e-5 of it
  // at two degrees.
  EXPECT_NEAR(calibration.disagreement / degree, sum / 6.0, 1e-3);
}

TEST(Calibrate, HearsFromTheMatteSphereHowThePicturesAreEncoded) {
  for (const bool linear : {true, false}) {
    Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
    photographs.encoding_known = false;
    photographs.linear = !linear;  // the assumption that it must correct
    if (!linear) {
      for (Image& image : photographs.images) {
        for (float& value : image.planes[0]) value = srgb_from_linear(value);
      }
    }
    EXPECT_EQ(calibrate(photographs).linear, linear);
  }
}

TEST(Calibrate, HearsNothingOfTheEncodingFromAnEvenDisc) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  photographs.encoding_known = false;
  photographs.linear = false;
  dim_disc(photographs.images[3].planes[0], {60.0, 55.0}, 26.0, 0.0f, 0.01f);
  const Calibration calibration = calibrate(photographs);
  EXPECT_TRUE(calibration.linear);
  EXPECT_THAT(calibration.remarks,
              testing::Contains(testing::ContainsRegex("off by ..?\\.. % that way, by ..\\.. %")));
}

TEST(Calibrate, LeavesAMatteSphereInShadowToTheOthers) {
  for (const float ambient : {0.0f, 0.01f}) {
    Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0, 12.0)});
    const Calibration before = calibrate(photographs);
    dim_disc(photographs.images[3].planes[0], {60.0, 55.0}, 26.0, 0.03f, ambient);
    const Calibration calibration = calibrate(photographs);
    EXPECT_FALSE(std::isfinite(calibration.readings[1].lights[3].direction_sigma));
    // The mirror and the sample know this light by themselves, about as well.
    EXPECT_LT(angle_deg(calibration.lights[3].direction, before.lights[3].direction), 0.5);
    EXPECT_NEAR(calibration.lights[3].strength[0], before.lights[3].strength[0], 0.02);
  }
}

TEST(Calibrate, RefusesALightWhoseStrengthNothingTells) {
  Rig rig = table_rig({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0, 12.0)});
  rig.lights.resize(4);  // too few for the sample to tell strengths
  Photographs photographs = photographs_of(photograph(waved_sheet(24.0), rig));
  dim_disc(photographs.images[3].planes[0], {60.0, 55.0}, 26.0, 0.03f, 0.0f);
  try {
    calibrate(photographs);
    FAIL() << "a strength was made up";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("picture_3.png: no matte sphere is well lit"));
  }
}

TEST(Calibrate, SigmaIsOfTheOrderOfTheError) {
  const Calibration calibration = calibrate(table_scene({matte_at(-18.0, 0.0)}));
  const auto truth = six_lights();
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double error = angle_deg(calibration.lights[k].direction, truth[k].direction) * degree;
    // Two tangent axes: 4 sigma holds all but 3 in 10 000 draws of a fair sigma.
    EXPECT_LT(error, 4.0 * std::max(calibration.lights[k].direction_sigma, 0.001));
  }
}

TEST(Calibrate, FindsTheSameBytesOnOneAndTwoThreads) {
  const Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  set_threads(1);
  const Calibration one = calibrate(photographs);
  set_threads(2);
  const Calibration two = calibrate(photographs);
  set_threads(0);
  for (std::size_t k = 0; k < one.lights.size(); ++k) {
    EXPECT_EQ(one.lights[k].direction, two.lights[k].direction);
    EXPECT_EQ(one.lights[k].direction_sigma, two.lights[k].direction_sigma);
  }
}

TEST(Calibrate, SaysThatThereIsNoSphere) {
  EXPECT_THROW(calibrate(table_scene({})), Error);
}

TEST(Calibrate, FindsTheSameLightsInPicturesOnDisk) {
  const Photographs in_memory = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  Photographs on_disk = in_memory;
  put_on_disk(on_disk);
  const Calibration expected = calibrate(in_memory);
  const Calibration found = calibrate(on_disk);
  EXPECT_EQ(found.remarks, expected.remarks);
  for (std::size_t k = 0; k < expected.lights.size(); ++k) {
    EXPECT_EQ(found.lights[k].direction, expected.lights[k].direction);
    EXPECT_EQ(found.lights[k].strength, expected.lights[k].strength);
    EXPECT_EQ(found.lights[k].direction_sigma, expected.lights[k].direction_sigma);
  }
}

}  // namespace
}  // namespace hada
