#include "capture/load.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "io/image_file.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

class Load : public ::testing::Test {
 protected:
  Load() { file_.folder = folder_.path(); }

  std::filesystem::path picture(const std::string& name, float value, int rows = 20,
                                int cols = 30) {
    write_integer_image(folder_ / name, Image(Grid<float>(rows, cols, value)), 16);
    return folder_ / name;
  }
  void add(const std::string& name, float value, int rows = 20, int cols = 30) {
    file_.pictures.push_back({picture(name, value, rows, cols), name, {}, {}});
  }
  std::string complaint() const {
    return error_of([&] { load_photographs(file_); });
  }

  TemporaryFolder folder_;
  CaptureFile file_;
};

TEST_F(Load, ReadsPicturesAndKnowsThatDeepOnesAreLinear) {
  add("a.png", 0.25f);
  add("b.png", 0.5f);
  const Photographs photographs = load_photographs(file_);
  EXPECT_EQ(photographs.images.size(), 2u);
  EXPECT_EQ(photographs.bits, 16);
  EXPECT_TRUE(photographs.linear && photographs.encoding_known);
  EXPECT_NEAR(photographs.images[1].planes[0](3, 3), 0.5f, 1e-5f);
  EXPECT_EQ(photographs.camera.extent.unit, Unit::px);
}

TEST_F(Load, NamesThePictureOfAnotherSize) {
  add("a.png", 0.25f);
  add("b.png", 0.5f, 20, 31);
  EXPECT_NE(complaint().find("b.png: is 31 x 20"), std::string::npos);
}

TEST_F(Load, RefusesBlackAndWhitePictures) {
  add("a.png", 0.0f);
  EXPECT_NE(complaint().find("all black"), std::string::npos);
  file_.pictures.clear();
  add("w.png", 1.0f);
  EXPECT_NE(complaint().find("all white"), std::string::npos);
}

TEST_F(Load, RefusesValuesThatAreNoNumbers) {
  write_exr(folder_ / "n.exr", Image(Grid<float>(20, 30, std::nanf(""))));
  file_.pictures.push_back({folder_ / "n.exr", "n.exr", {}, {}});
  EXPECT_NE(complaint().find("not numbers"), std::string::npos);
}

TEST_F(Load, RefusesPicturesTooSmallForASphere) {
  add("a.png", 0.4f, 1, 1);
  EXPECT_NE(complaint().find("only 1 x 1"), std::string::npos);
}

TEST_F(Load, LinearizesBySubtractingAmbientAndDividingByTheFlatField) {
  add("a.png", 0.5f);
  file_.ambient = picture("ambient.png", 0.1f);
  Image flat(Grid<float>(20, 30, 0.4f));
  for (int col = 15; col < 30; ++col) {
    for (int row = 0; row < 20; ++row) flat.planes[0](row, col) = 0.8f;
  }
  write_integer_image(folder_ / "flat.png", flat, 16);
  file_.flat = folder_ / "flat.png";
  const Photographs linear = linearized(load_photographs(file_));
  // (0.5 - 0.1) / (0.4 / 0.6) and / (0.8 / 0.6), to the rounding of 16 bits.
  EXPECT_NEAR(linear.images[0].planes[0](0, 0), 0.6f, 1e-4f);
  EXPECT_NEAR(linear.images[0].planes[0](0, 29), 0.3f, 1e-4f);
}

TEST_F(Load, GivesCornersBackWhatTheLensTook) {
  add("a.png", 0.5f);
  file_.vignetting = {-0.25, 0.0, -0.05};
  const Photographs loaded = load_photographs(file_);
  EXPECT_FALSE(is_linearized(loaded));
  const Photographs linear = linearized(loaded);
  EXPECT_TRUE(is_linearized(linear));
  // The middle of the corner pixel lies at 0.97 of the half diagonal of 20 x 30 pixels.
  const double square = (9.5 * 9.5 + 14.5 * 14.5) / (10.0 * 10.0 + 15.0 * 15.0);
  const double left = 1.0 - 0.25 * square - 0.05 * square * square * square;
  EXPECT_NEAR(linear.images[0].planes[0](0, 0), 0.5 / left, 2e-5);
  EXPECT_NEAR(linear.images[0].planes[0](10, 15), 0.5, 1e-3);
}

TEST_F(Load, AsksForTheFocalLengthOfAPerspectiveCamera) {
  add("a.png", 0.5f);
  file_.camera = CaptureFile::CameraHint{.perspective = true, .focal_px = {}, .distance_mm = 900.0};
  EXPECT_NE(complaint().find("needs focal_px"), std::string::npos);
  file_.pitch_mm = 0.3;
  EXPECT_NEAR(load_photographs(file_).camera.focal_px, 3000.0, 1e-9);
}

TEST_F(Load, KeepsTheSamePicturesOnDisk) {
  for (const char* const name : {"a.png", "b.png", "c.png"}) add(name, 0.5f);
  file_.dark = picture("dark.png", 0.1f);
  const Photographs in_memory = load_photographs(file_, {.memory = nullptr});
  const Photographs on_disk = load_photographs(file_, {.memory = scratch_files()});
  EXPECT_EQ(load_photographs(file_).images[0].memory(), nullptr);  // they are small
  EXPECT_EQ(on_disk.images[2].memory(), scratch_files());
  EXPECT_EQ(on_disk.images, in_memory.images);
  EXPECT_EQ(on_disk.saturated, in_memory.saturated);
  const Photographs copy = copy_of(on_disk);
  EXPECT_EQ(copy.images[2].memory(), scratch_files());
  EXPECT_EQ(copy.images, in_memory.images);
  EXPECT_EQ(linearized(on_disk).images, linearized(in_memory).images);
  EXPECT_TRUE(is_linearized(linearized(on_disk)));
  EXPECT_FALSE(is_linearized(on_disk));
}

}  // namespace
}  // namespace hada
