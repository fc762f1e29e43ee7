#include "capture/movement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/light_stack.h"
#include "table_scene.h"

namespace hada {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<Sphere>& spheres() {
  static const std::vector<Sphere> both{{SphereKind::matte, {60.0, 55.0}, 25.0, 0.1, {}},
                                        {SphereKind::chrome, {50.0, 145.0}, 25.0, 0.1, {}}};
  return both;
}

LightStack good_stack() {
  auto lights = six_lights();
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k].image = "picture_" + std::to_string(k) + ".png";
  }
  return light_stack(table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)}), lights,
                     spheres());
}

// Shifts the part of a picture that lies right of `first_col`.
void shift(Image& image, int right, int down, int first_col) {
  const Grid<float> before = image.planes[0];
  for (int row = 0; row < before.rows(); ++row) {
    for (int col = first_col; col < before.cols(); ++col) {
      image.planes[0](row, col) = before(std::clamp(row - down, 0, before.rows() - 1),
                                         std::clamp(col - right, 0, before.cols() - 1));
    }
  }
}

std::vector<std::string> remarks_on(const LightStack& stack) {
  return remarks_on_movement(stack.images, stack.lights, spheres(), stack.mask);
}

TEST(Movement, IsNotSeenWhereNothingMoved) {
  EXPECT_THAT(remarks_on(good_stack()), IsEmpty());
}

TEST(Movement, OfTheCameraIsNamedWithItsPictureAndSize) {
  LightStack stack = good_stack();
  shift(stack.images[2], 4, -3, 0);
  EXPECT_THAT(remarks_on(stack),
              ElementsAre(HasSubstr("picture_2.png is shifted by about 5 px against the other "
                                    "pictures: the camera moved")));
}

TEST(Movement, OfTheSampleIsToldFromThatOfTheCamera) {
  LightStack stack = good_stack();
  shift(stack.images[4], -6, 0, 100);
  EXPECT_THAT(remarks_on(stack), ElementsAre(AllOf(HasSubstr("In picture_4.png the sample lies"),
                                                   HasSubstr("6 px off its place"))));
}

// A stack of a rig, with the lights it was made with.
LightStack stack_of(const Surface& sheet, const Rig& rig) {
  auto lights = rig.lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k].image = "picture_" + std::to_string(k) + ".png";
  }
  const Sphere sphere{SphereKind::matte, {60.0, 55.0}, 25.0, 0.1, {}};
  return light_stack(photographs_of(photograph(sheet, rig)), lights, {sphere});
}

TEST(Movement, IsNotReadOffTheHoleThatASphereLeavesInTheSample) {
  // Nothing but sheet and sphere: the rig's table is as bright as a sheet.
  Rig rig = table_rig({matte_at(-18.0, 9.0)});
  rig.table_albedo = 0.8;
  const LightStack stack = stack_of(waved_sheet(24.0), rig);
  EXPECT_THAT(remarks_on_movement(stack.images, stack.lights,
                                  {{SphereKind::matte, {60.0, 55.0}, 25.0, 0.1, {}}}, stack.mask),
              IsEmpty());
}

TEST(Movement, IsNotReadOffTheShadingOfASphereOnABrightTable) {
  Rig rig = table_rig({matte_at(-18.0, 9.0)});
  rig.table_albedo = 0.3;
  rig.lights = {light_at(28, 12),  light_at(46, 55),  light_at(34, 101), light_at(50, 147),
                light_at(25, 188), light_at(42, 236), light_at(38, 283), light_at(48, 329)};
  const LightStack stack = stack_of(waved_sheet(24.0), rig);
  EXPECT_THAT(remarks_on_movement(stack.images, stack.lights,
                                  {{SphereKind::matte, {60.0, 55.0}, 25.0, 0.1, {}}}, {}),
              IsEmpty());
}

TEST(Movement, IsMeasuredToAPixel) {
  LightStack stack = good_stack();
  shift(stack.images[1], 7, 2, 0);
  std::vector<Grid<float>> greys;
  std::vector<Eigen::Vector2d> towards;
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    greys.push_back(stack.images[k].planes[0]);
    towards.emplace_back(stack.lights[k].direction.x(), -stack.lights[k].direction.y());
  }
  Outline ball{"the ball", true, {}, {}};
  for (int i = 0; i < 150; ++i) {
    const Eigen::Vector2d outward(std::cos(i * 2.4 * degree), std::sin(i * 2.4 * degree));
    const Eigen::Vector2d at = spheres()[0].center_px + 25.0 * outward;
    ball.pixels.emplace_back(int(std::floor(at.x())), int(std::floor(at.y())));
    ball.inward.push_back(-outward);
  }
  const auto shifts = movements(greys, towards, ball);
  // Whole pixels of an outline that is rounded to pixels: half of one along each axis.
  EXPECT_LT((shifts[1] - Eigen::Vector2d(7.0, 2.0)).cwiseAbs().maxCoeff(), 0.5);
  EXPECT_LT(shifts[0].norm(), 0.5);
}

}  // namespace
}  // namespace hada
