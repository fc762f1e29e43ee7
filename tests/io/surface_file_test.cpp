#include "io/surface_file.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/image_file.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

// A paraboloid seen through a mask with one corner cut off, every map filled.
Surface dome() {
  Surface surface;
  surface.extent = {12, 15, 0.25, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.mask(0, 0) = surface.mask(0, 1) = surface.mask(1, 0) = 0;
  surface.height = Grid<float>(12, 15);
  for (int row = 0; row < 12; ++row) {
    for (int col = 0; col < 15; ++col) {
      surface.height(row, col) = float(-0.1 * surface.extent.place(row, col).squaredNorm());
    }
  }
  surface.normals = normals_of(surface.height, surface.mask, surface.extent.pitch);
  surface.albedo = Image(12, 15, 3);
  for (auto& plane : surface.albedo.planes) plane = Grid<float>(12, 15, 0.5f);
  surface.normal_sigma = Grid<float>(12, 15, 0.01f);
  surface.height_sigma = Grid<float>(12, 15, 0.02f);
  surface.levelling = "plane";
  surface.offset_px = {7, 9};
  return surface;
}

void write(const std::filesystem::path& folder, const Surface& surface) {
  Output output(folder);
  write_surface(output, "", surface, R"({"remark": "test"})");
  output.commit();
}

template <class T>
bool equal_inside(const Grid<T>& a, const Grid<T>& b, const Mask& mask) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] && !(a[i] == b[i])) return false;
  }
  return a.same_size(b);
}

TEST(SurfaceFile, ReturnsTheHeightAloneWhereThatIsAskedFor) {
  const TemporaryFolder folder;
  Surface surface = dome();
  write(folder / "s", surface);
  const Surface again = read_surface(folder / "s", {}, SurfaceMaps::height_alone);
  EXPECT_EQ(again.mask, surface.mask);
  EXPECT_TRUE(equal_inside(again.height, surface.height, surface.mask));
  EXPECT_TRUE(again.normals.empty() && again.albedo.empty() && again.height_sigma.empty());
  const Surface map =
      read_surface(folder / "s" / "height.exr", surface.extent.pitch, SurfaceMaps::height_alone);
  EXPECT_TRUE(map.has_height() && map.normals.empty());
  // Where there is none, the rest is read.
  surface.height = {};
  write(folder / "flat", surface);
  EXPECT_FALSE(read_surface(folder / "flat", {}, SurfaceMaps::height_alone).albedo.empty());
}

TEST(SurfaceFile, ReturnsEveryMapThatWasWritten) {
  const TemporaryFolder folder;
  const Surface surface = dome();
  write(folder / "s", surface);
  const Surface again = read_surface(folder / "s");
  EXPECT_EQ(again.extent, surface.extent);
  EXPECT_EQ(again.mask, surface.mask);
  EXPECT_TRUE(equal_inside(again.height, surface.height, surface.mask));
  EXPECT_TRUE(equal_inside(again.normals, surface.normals, surface.mask));
  EXPECT_TRUE(equal_inside(again.albedo.planes[2], surface.albedo.planes[2], surface.mask));
  EXPECT_TRUE(equal_inside(again.normal_sigma, surface.normal_sigma, surface.mask));
  EXPECT_TRUE(equal_inside(again.height_sigma, surface.height_sigma, surface.mask));
  EXPECT_EQ(again.levelling, "plane");
  EXPECT_EQ(again.offset_px, Eigen::Vector2i(7, 9));
}

TEST(SurfaceFile, WritesNotNumbersOutsideTheMask) {
  const TemporaryFolder folder;
  write(folder / "s", dome());
  const Image height = read_image(folder / "s/height.exr").image;
  EXPECT_EQ(height.channels(), 1);
  EXPECT_TRUE(std::isnan(height.planes[0](0, 0)));
  EXPECT_FALSE(std::isnan(height.planes[0](1, 1)));
  EXPECT_EQ(read_image(folder / "s/mask.png").image.planes[0](0, 0), 0.0f);
}

TEST(SurfaceFile, IgnoresMapsLeftFromAnEarlierSurface) {
  const TemporaryFolder folder;
  write(folder / "s", dome());
  Surface picture;
  picture.extent = {4, 4, 1.0, Unit::px};
  picture.mask = full_mask(picture.extent);
  picture.albedo = Image(4, 4, 1);
  write(folder / "s", picture);
  const Surface again = read_surface(folder / "s");
  EXPECT_FALSE(again.has_height());
  EXPECT_TRUE(again.normals.empty());
  EXPECT_EQ(again.albedo.rows(), 4);
}

TEST(SurfaceFile, GrowsTheWholeSurfaceWithAnotherPitch) {
  const TemporaryFolder folder;
  const Surface surface = dome();
  write(folder / "s", surface);
  const Surface larger = read_surface(folder / "s", 0.5);
  EXPECT_EQ(larger.extent.pitch, 0.5);
  EXPECT_FLOAT_EQ(larger.height(5, 5), 2.0f * surface.height(5, 5));
  EXPECT_FLOAT_EQ(larger.height_sigma(5, 5), 2.0f * surface.height_sigma(5, 5));
  EXPECT_EQ(larger.normals(5, 5), surface.normals(5, 5));
}

TEST(SurfaceFile, TakesOneFloatChannelForAHeightMap) {
  const TemporaryFolder folder;
  Grid<float> ramp(6, 8);
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 8; ++col) ramp(row, col) = float(100 + col);
  }
  ramp(2, 2) = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder / "h.exr", Image(ramp));
  const Surface surface = read_surface(folder / "h.exr", 0.5);
  EXPECT_EQ(surface.extent, (Extent{6, 8, 0.5, Unit::mm}));
  EXPECT_EQ(surface.mask(2, 2), 0);
  double sum = 0.0;
  for (const float height : surface.height) sum += height;
  EXPECT_NEAR(sum, 0.0, 48 * 4 * 0x1p-23);  // float rounding of 48 values below 4
  // One height per column of 0.5 mm: a slope of 2.
  const Eigen::Vector3f expected = Eigen::Vector3f(-2.0f, 0.0f, 1.0f).normalized();
  EXPECT_LT((surface.normals(4, 4) - expected).norm(), 1e-6f);
  EXPECT_EQ(read_surface(folder / "h.exr").extent.unit, Unit::px);
}

TEST(SurfaceFile, TakesAPlainPictureForALinearAlbedo) {
  const TemporaryFolder folder;
  Image grey(3, 4, 1);
  grey.planes[0] = Grid<float>(3, 4, 0.5f);
  Image colour(3, 4, 3);
  for (auto& plane : colour.planes) plane = Grid<float>(3, 4, 0.25f);
  write_integer_image(folder / "a8.png", grey, 8);
  write_integer_image(folder / "a16.png", grey, 16);
  write_exr(folder / "colour.exr", colour);
  const Surface from8 = read_surface(folder / "a8.png");
  EXPECT_FALSE(from8.has_height());
  EXPECT_FLOAT_EQ(from8.albedo.planes[0](1, 1), linear_from_srgb(128.0f / 255.0f));
  EXPECT_FLOAT_EQ(read_surface(folder / "a16.png").albedo.planes[0](1, 1), 32768.0f / 65535.0f);
  const Surface of_colour = read_surface(folder / "colour.exr", 0.1);
  EXPECT_EQ(of_colour.albedo, colour);
  EXPECT_EQ(of_colour.extent.unit, Unit::mm);
}

TEST(SurfaceFile, NamesWhatIsWrong) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& name) {
    return error_of([&] { read_surface(folder / name); });
  };
  write_exr(folder / "dot.exr", Image(Grid<float>(1, 1, 1.0f)));
  EXPECT_THAT(error("dot.exr"), HasSubstr("dot.exr: is 1 x 1 pixels, too small"));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder / "nan.exr", Image(Grid<float>(5, 5, nan)));
  EXPECT_THAT(error("nan.exr"), HasSubstr("nan.exr: no pixel has a meaning"));
  EXPECT_THAT(error("none.exr"), HasSubstr("no such file"));
  EXPECT_THAT(error_of([&] { read_surface(folder.path()); }), HasSubstr("without surface.json"));
  EXPECT_THAT(error_of([&] { read_surface(folder / "dot.exr", 0.0); }), HasSubstr("the pitch"));

  write(folder / "s", dome());
  write_exr(folder / "s/height.exr", Image(Grid<float>(5, 5, 1.0f)));
  EXPECT_THAT(error("s"), HasSubstr("height.exr: is not of the size"));
  write_exr(folder / "s/height.exr", Image(Grid<float>(12, 15, nan)));
  EXPECT_THAT(error("s"), HasSubstr("height.exr: holds a value inside the mask"));
  write(folder / "s", dome());
  write_exr(folder / "s/normal.exr", Image(12, 15, 3));
  EXPECT_THAT(error("s"), HasSubstr("normal.exr: holds a vector that is no normal"));
  write(folder / "s", dome());
  std::filesystem::remove(folder / "s/albedo.exr");
  EXPECT_THAT(error("s"), HasSubstr("albedo.exr: no such file"));
}

}  // namespace
}  // namespace hada
