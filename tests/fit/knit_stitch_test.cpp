#include "fit/knit_stitch.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(MeanStitch, FoldsAPictureOntoOneRepeat) {
  Knit<> knit;
  knit.wale_mm = 1.6;
  knit.course_mm = 1.2;
  knit.colour_repeat = {0.0};
  Surface surface;
  surface.extent = {240, 320, 0.1, Unit::mm};  // 20 wales of 16 px, 20 courses of 12 px
  surface.mask = full_mask(surface.extent);
  Grid<float> plane(240, 320);
  const auto value = [](double wale) { return 0.5 + 0.2 * std::cos(2.0 * 3.14159265 * wale); };
  for (int row = 0; row < 240; ++row) {
    for (int col = 0; col < 320; ++col) {
      const Eigen::Vector2d place = surface.extent.place(row, col);
      plane(row, col) = float(value(stitch_at(knit, place.x(), place.y())[0]));
    }
  }
  surface.albedo = Image(plane);
  const auto mean = mean_stitch(surface, knit, 16);
  ASSERT_EQ(mean.planes.size(), 1u);
  ASSERT_EQ(mean.planes[0].cols(), 16);
  double pixels = 0.0, lowest = 1.0, highest = 0.0;
  for (std::size_t i = 0; i < mean.weight.size(); ++i) {
    pixels += mean.weight[i];
    lowest = std::min(lowest, double(mean.planes[0][i]));
    highest = std::max(highest, double(mean.planes[0][i]));
  }
  EXPECT_NEAR(pixels, 240.0 * 320.0, 1.0);
  // The wave keeps its height but for what a place of a sixteenth averages, 1 - cos(pi / 16).
  EXPECT_NEAR(highest, 0.7, 0.2 * 0.02 + 1e-3);
  EXPECT_NEAR(lowest, 0.3, 0.2 * 0.02 + 1e-3);
}

}  // namespace
}  // namespace hada
