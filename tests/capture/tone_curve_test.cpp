#include "capture/tone_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "table_scene.h"

namespace hada {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Photographs bent_scene(double gamma) {
  Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  for (Image& image : photographs.images) {
    for (float& value : image.planes[0]) {
      value = float(std::pow(std::max(0.0f, value), 1.0 / gamma));
    }
  }
  return photographs;
}

TEST(ToneCurve, IsMeasuredOnTheMatteSphere) {
  // The outline of the sphere was drawn under the wrong curve: the exponent is off by up to 0.1.
  EXPECT_THAT(calibrate(bent_scene(1.8)).remarks,
              Contains(ContainsRegex("These pictures are not linear .gamma about 1.[789]")));
}

TEST(ToneCurve, ThatHidesTheSphereIsNamed) {
  try {
    calibrate(bent_scene(2.2));
    FAIL() << "a sphere was found";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("read as sRGB there is one"));
  }
}

TEST(ToneCurve, IsFoundWhereLinearPicturesAreTakenAsSrgb) {
  Photographs photographs = bent_scene(1.0);
  photographs.linear = false;
  EXPECT_THAT(calibrate(photographs).remarks,
              Contains(HasSubstr("Taken as sRGB these pictures are not linear")));
}

TEST(ToneCurve, IsNotSeenInLinearPictures) {
  const Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  EXPECT_THAT(remarks_on_curve(photographs, calibrate(photographs)), IsEmpty());
}

TEST(ToneCurve, IsNotAskedOfAnEvenDisc) {
  Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  dim_disc(photographs.images[3].planes[0], {60.0, 55.0}, 26.0, 0.0f, 0.01f);
  EXPECT_THAT(calibrate(photographs).remarks, Not(Contains(HasSubstr("not linear"))));
}

}  // namespace
}  // namespace hada
