#include "io/image_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel.h"
#include "core/random.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

// Noise, so that no format can pack it well and a cut takes real pixels away.
Image noise(int rows, int cols, int channels) {
  Image image(rows, cols, channels);
  for (int c = 0; c < channels; ++c) {
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        image.planes[std::size_t(c)](row, col) = float(uniform(7, row, col, c));
      }
    }
  }
  return image;
}

double largest_difference(const Image& a, const Image& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < a.planes.size(); ++c) {
    for (std::size_t i = 0; i < a.planes[c].size(); ++i) {
      largest = std::max(largest, std::abs(double(a.planes[c][i]) - b.planes[c][i]));
    }
  }
  return largest;
}

// An uncompressed TGA, written by the book (Truevision 1989): 18 bytes of header, then B, G, R[,
// A].
std::string tga(int rows, int cols, int channels, const std::string& pixels) {
  std::string bytes(18, '\0');
  bytes[2] = channels == 1 ? 3 : 2;
  bytes[12] = char(cols % 256);
  bytes[13] = char(cols / 256);
  bytes[14] = char(rows % 256);
  bytes[15] = char(rows / 256);
  bytes[16] = char(8 * channels);
  bytes[17] = char(0x20 | (channels == 4 ? 8 : 0));  // row 0 at the top
  return bytes + pixels;
}

TEST(ImageFile, ReturnsFloatsExactlyAsTheyWereWritten) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3}) {
    Image image = noise(17, 23, channels);
    image.planes[0](3, 4) = -1e30f;
    image.planes[0](5, 6) = HUGE_VALF;
    write_exr(folder / "a.exr", image);
    const ImageFile file = read_image(folder / "a.exr");
    EXPECT_EQ(file.image, image);
    EXPECT_TRUE(file.floating);
    EXPECT_EQ(file.bits, 32);
  }
}

TEST(ImageFile, KeepsValuesThatAreNotNumbers) {
  const TemporaryFolder folder;
  Image image = noise(4, 5, 1);
  image.planes[0](1, 2) = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder / "a.exr", image);
  EXPECT_TRUE(std::isnan(read_image(folder / "a.exr").image.planes[0](1, 2)));
}

TEST(ImageFile, ReturnsIntegersWithinHalfAStepAndTheEndsExactly) {
  const TemporaryFolder folder;
  for (const std::string name : {"a.png", "a.tif"}) {
    for (const int bits : {8, 16}) {
      for (const int channels : {1, 3}) {
        Image image = noise(19, 31, channels);
        image.planes[0](0, 0) = -0.5f;  // clipped to 0
        image.planes[0](0, 1) = 1.5f;   // clipped to 1
        write_integer_image(folder / name, image, bits);
        const ImageFile file = read_image(folder / name);
        EXPECT_EQ(file.bits, bits);
        EXPECT_FALSE(file.floating);
        EXPECT_EQ(file.image.channels(), channels);
        EXPECT_EQ(file.image.planes[0](0, 0), 0.0f);
        EXPECT_EQ(file.image.planes[0](0, 1), 1.0f);
        image.planes[0](0, 0) = 0.0f;
        image.planes[0](0, 1) = 1.0f;
        // Half a step of rounding, and 2^-23 of float arithmetic on the way there and back.
        EXPECT_LE(largest_difference(file.image, image), 0.5 / ((1 << bits) - 1) + 0x1p-22);
      }
    }
  }
}

TEST(ImageFile, ScalesEveryByteByOneOver255) {
  const TemporaryFolder folder;
  std::string pixels;
  for (int value = 0; value < 256; ++value) pixels += char(value);
  put(folder / "a.tga", tga(16, 16, 1, pixels));
  const Image image = read_image(folder / "a.tga").image;
  ASSERT_EQ(image.channels(), 1);
  for (int i = 0; i < 256; ++i) EXPECT_FLOAT_EQ(image.planes[0][std::size_t(i)], float(i) / 255.0f);
  EXPECT_EQ(image.planes[0][255], 1.0f);
}

TEST(ImageFile, DropsAlphaWithoutMultiplyingByIt) {
  const TemporaryFolder folder;
  put(folder / "a.tga", tga(1, 2, 4, std::string("\x10\x20\x30\x00\x40\x50\x60\x80", 8)));
  const Image image = read_image(folder / "a.tga").image;
  ASSERT_EQ(image.channels(), 3);
  EXPECT_FLOAT_EQ(image.planes[0](0, 0), 0x30 / 255.0f);
  EXPECT_FLOAT_EQ(image.planes[2](0, 0), 0x10 / 255.0f);
  EXPECT_FLOAT_EQ(image.planes[1](0, 1), 0x50 / 255.0f);
}

TEST(ImageFile, RefusesEveryTruncatedFile) {
  const TemporaryFolder folder;
  write_exr(folder / "whole.exr", noise(60, 50, 3));
  write_integer_image(folder / "whole.png", noise(60, 50, 3), 8);
  write_integer_image(folder / "whole.tif", noise(60, 50, 3), 16);
  put(folder / "whole.tga", tga(60, 50, 3, std::string(9000, 'x')));
  for (const std::string ending : {".exr", ".png", ".tif", ".tga"}) {
    const std::string whole = bytes_of(folder / ("whole" + ending));
    ASSERT_NO_THROW(read_image(folder / ("whole" + ending)));
    for (const double part : {0.001, 0.02, 0.3, 0.7, 0.97}) {
      const auto cut = folder / ("cut" + ending);
      put(cut, whole.substr(0, std::size_t(part * double(whole.size())) + 1));
      testing::internal::CaptureStderr();
      const std::string error = error_of([&] { read_image(cut); });
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      EXPECT_THAT(error, HasSubstr("cut" + ending + ": is")) << part;
      EXPECT_EQ(error.find('\n'), std::string::npos);
    }
  }
}

TEST(ImageFile, SaysOfWhatIsNoPictureThatItIsNone) {
  const TemporaryFolder folder;
  put(folder / "text.png", "This is a letter and not a picture.\n");
  put(folder / "text.exr", "This is a letter and not a picture.\n");
  put(folder / "text.tga", "This is a letter and not a picture.\n");
  put(folder / "text.jpg", "This is a letter and not a picture.\n");
  put(folder / "text.tif", "This is a letter and not a picture.\n");
  put(folder / "empty.png", "");
  testing::internal::CaptureStderr();
  for (const std::string ending : {"png", "exr", "jpg", "tif", "tga"}) {
    const auto path = folder / ("text." + ending);
    EXPECT_THAT(error_of([&] { read_image(path); }), HasSubstr("text." + ending + ": is"));
  }
  EXPECT_THAT(error_of([&] { read_image(folder / "text.png"); }), HasSubstr("not a picture"));
  EXPECT_THAT(error_of([&] { read_image(folder / "empty.png"); }), HasSubstr("is empty"));
  EXPECT_THAT(error_of([&] { read_image(folder / "none.png"); }), HasSubstr("no such file"));
  EXPECT_THAT(error_of([&] { read_image(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ImageFile, RefusesAClaimedSizeBeforeAllocatingIt) {
  const TemporaryFolder folder;
  put(folder / "huge.tga", tga(65535, 65535, 3, "xyz"));
  EXPECT_THAT(error_of([&] { read_image(folder / "huge.tga"); }), HasSubstr("65535 x 65535"));
  put(folder / "large.tga", tga(8000, 8000, 3, "xyz"));
  EXPECT_THAT(error_of([&] { read_image(folder / "large.tga"); }), HasSubstr("too short"));
}

TEST(ImageFile, WritesTheSameBytesEveryTimeAtAnyThreadCount) {
  const TemporaryFolder folder;
  const Image image = noise(300, 200, 3);
  for (const std::string ending : {".exr", ".png", ".tif"}) {
    const auto write = [&](const std::string& name) {
      if (ending == ".exr")
        write_exr(folder / name, image);
      else
        write_integer_image(folder / name, image, 16);
      return bytes_of(folder / name);
    };
    set_threads(1);
    const std::string once = write("once" + ending);
    set_threads(3);
    EXPECT_EQ(write("again" + ending), once) << ending;
    set_threads(0);
  }
}

TEST(ImageFile, EncodesThePngThatItWouldWrite) {
  const TemporaryFolder folder;
  const Image image = noise(20, 30, 3);
  const auto bytes = encode_png(image);
  put(folder / "a.png", std::string(bytes.begin(), bytes.end()));
  write_integer_image(folder / "b.png", image, 8);
  EXPECT_EQ(read_image(folder / "a.png").image, read_image(folder / "b.png").image);
}

TEST(ImageFile, SaysWhenItCannotWrite) {
  const TemporaryFolder folder;
  const Image image = noise(200, 200, 3);
  for (const std::string ending : {".exr", ".png", ".tif"}) {
    const auto write = [&](const std::filesystem::path& path) {
      return error_of(
          [&] { ending == ".exr" ? write_exr(path, image) : write_integer_image(path, image, 8); });
    };
    const auto full = folder / ("full" + ending);
    std::filesystem::create_symlink("/dev/full", full);  // the disk that never has space
    testing::internal::CaptureStderr();
    EXPECT_THAT(write(full), HasSubstr("cannot be written"));
    EXPECT_THAT(write(folder / ("no/such/folder" + ending)), HasSubstr("cannot be written"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

TEST(ImageFile, KnowsImagesByTheEndingOfTheirNames) {
  EXPECT_TRUE(has_image_name("a/IMG_1.JPG"));
  EXPECT_TRUE(has_image_name("buddha.0.tga"));
  EXPECT_FALSE(has_image_name("notes.txt"));
  EXPECT_FALSE(has_image_name("png"));
}

TEST(SrgbCurve, IsItsOwnInverseAndJoinsItsTwoPieces) {
  EXPECT_FLOAT_EQ(srgb_from_linear(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(linear_from_srgb(1.0f), 1.0f);
  // Middle grey of the standard: 0.5 encoded is 0.214041 linear.
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.2140411, 1e-6);
  for (int i = 0; i <= 255; ++i) {
    // The steepest part of the curve, 12.92, enlarges float rounding at most so much.
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(float(i) / 255.0f)), float(i) / 255.0f, 1e-6);
  }
  // The rounded constants of the standard leave a gap of 3e-8 where the pieces meet.
  EXPECT_NEAR(linear_from_srgb(0.04045f), linear_from_srgb(std::nextafter(0.04045f, 1.0f)), 1e-7);
}

}  // namespace
}  // namespace hada
