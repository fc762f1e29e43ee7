#include "studio/surface_bytes.h"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

namespace hada {
namespace {

template <class T>
T at(const std::string& bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

// Binary16 as IEEE 754 has it.
double number_of(std::uint16_t half) {
  const int exponent = (half >> 10) & 31, rest = half & 1023;
  const double size =
      exponent == 0 ? rest * 0x1p-24 : (1024 + rest) * std::ldexp(1.0, exponent - 25);
  return half & 0x8000 ? -size : size;
}

TEST(SurfaceBytes, HoldWhatTheFlagsName) {
  Surface surface;
  surface.extent = {2, 3, 0.25, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.mask(1, 2) = 0;
  surface.height = Grid<float>(2, 3, 0.5f);
  surface.height(0, 1) = -2.0f;
  surface.height(1, 2) = 99.0f;  // outside: it has no meaning
  surface.normals = NormalMap(2, 3, Eigen::Vector3f(0.6f, -0.3f, 0.742f));
  surface.albedo = Image(Grid<float>(2, 3, 0.1234f));
  surface.normal_sigma = Grid<float>(2, 3, 0.01f);
  const std::string bytes = surface_bytes(surface);
  ASSERT_EQ(bytes.size(), 40u + 6 * (8 + 8 + 4 + 4));
  EXPECT_EQ(bytes.substr(0, 4), "HADA");
  EXPECT_EQ(at<std::uint32_t>(bytes, 4), 3u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 8), 2u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 12), 31u);
  EXPECT_EQ(at<float>(bytes, 16), 0.25f);
  EXPECT_EQ(at<float>(bytes, 20), -2.0f);
  EXPECT_EQ(at<float>(bytes, 24), 0.5f);
  EXPECT_EQ(at<float>(bytes, 28), 0.1234f);
  // Halves have 11 bits: they are off by half a unit of the last.
  EXPECT_NEAR(number_of(at<std::uint16_t>(bytes, 40)), 0.6, 0.6 * 0x1p-11);
  EXPECT_NEAR(number_of(at<std::uint16_t>(bytes, 42)), -0.3, 0.3 * 0x1p-11);
  EXPECT_EQ(number_of(at<std::uint16_t>(bytes, 46)), 1.0);
  EXPECT_EQ(number_of(at<std::uint16_t>(bytes, 40 + 5 * 8 + 6)), 0.0);  // not in the mask
  EXPECT_NEAR(number_of(at<std::uint16_t>(bytes, 88)), 0.1234, 0.1234 * 0x1p-11);
  EXPECT_EQ(at<float>(bytes, 136 + 4), -2.0f);
  EXPECT_EQ(at<float>(bytes, 32), 0.01f);
  EXPECT_EQ(at<float>(bytes, 36), 0.0f);
  EXPECT_EQ(at<float>(bytes, 160), 0.01f);
  surface.normals = {};
  surface.normal_sigma = {};
  surface.height = {};
  EXPECT_EQ(surface_bytes(surface).size(), 40u + 6 * 8);
}

}  // namespace
}  // namespace hada
