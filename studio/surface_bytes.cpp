#include "studio/surface_bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/parallel.h"

namespace hada {
namespace {

// Binary16 of numbers as they occur here: rounded, below 6e-5 taken for 0, above 65504 cut.
std::uint16_t half_of(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16) & 0x8000u, rest = (bits & 0x7fffffffu) + 0x1000u;
  if (rest < 0x38800000u) return std::uint16_t(sign);
  if (rest >= 0x47800000u) return std::uint16_t(sign | 0x7bffu);
  return std::uint16_t(sign | ((rest - 0x38000000u) >> 13));
}

// The value that only one pixel in 200 exceeds, of every seventh pixel.
float high_end(const Grid<float>& plane, const Mask& mask) {
  std::vector<float> values;
  for (std::size_t i = 0; i < plane.size(); i += 7) {
    if (mask[i] && std::isfinite(plane[i])) values.push_back(plane[i]);
  }
  if (values.empty()) return 0.0f;
  const auto place = values.begin() + std::ptrdiff_t(0.995 * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

float white_of(const Surface& surface) {
  float white = 0.0f;
  for (const auto& plane : surface.albedo.planes) {
    white = std::max(white, high_end(plane, surface.mask));
  }
  return white;
}

template <class T>
void put(std::string& bytes, std::size_t place, const T& value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

}  // namespace

std::string surface_bytes(const Surface& surface) {
  const int rows = surface.extent.rows, cols = surface.extent.cols;
  const std::size_t pixels = std::size_t(rows) * std::size_t(cols);
  const bool normals = !surface.normals.empty(), albedo = !surface.albedo.empty(),
             height = surface.has_height(), normal_sigma = !surface.normal_sigma.empty(),
             height_sigma = !surface.height_sigma.empty();
  const std::size_t head = 40, at_albedo = head + (normals ? 8 * pixels : 0),
                    at_height = at_albedo + (albedo ? 8 * pixels : 0),
                    at_normal_sigma = at_height + (height ? 4 * pixels : 0),
                    at_height_sigma = at_normal_sigma + (normal_sigma ? 4 * pixels : 0);
  std::string bytes(at_height_sigma + (height_sigma ? 4 * pixels : 0), '\0');
  float low = 0.0f, high = 0.0f;
  for (std::size_t i = 0; height && i < pixels; ++i) {
    if (!surface.mask[i]) continue;
    low = std::min(low, surface.height[i]);
    high = std::max(high, surface.height[i]);
  }
  std::memcpy(bytes.data(), "HADA", 4);
  put(bytes, 4, std::uint32_t(cols));
  put(bytes, 8, std::uint32_t(rows));
  const bool mm = surface.extent.unit == Unit::mm;
  put(bytes, 12,
      std::uint32_t(normals + 2 * albedo + 4 * height + 8 * mm + 16 * normal_sigma +
                    32 * height_sigma));
  put(bytes, 16, float(surface.extent.pitch));
  put(bytes, 20, low);
  put(bytes, 24, high);
  put(bytes, 28, white_of(surface));
  put(bytes, 32, high_end(surface.normal_sigma, surface.mask));
  put(bytes, 36, high_end(surface.height_sigma, surface.mask));
  const auto& planes = surface.albedo.planes;
  for_slices(rows, [&](int begin, int end) {
    for (std::size_t i = std::size_t(begin) * std::size_t(cols);
         i < std::size_t(end) * std::size_t(cols); ++i) {
      const bool counts = surface.mask[i] != 0;
      if (normals) {
        const Eigen::Vector3f n = counts ? surface.normals[i] : Eigen::Vector3f(0, 0, 1);
        const std::uint16_t four[4] = {half_of(n.x()), half_of(n.y()), half_of(n.z()),
                                       half_of(counts ? 1.0f : 0.0f)};
        std::memcpy(bytes.data() + head + 8 * i, four, 8);
      }
      if (albedo) {
        const bool colour = planes.size() == 3;
        const auto value = [&](std::size_t c) {
          return half_of(counts ? planes[colour ? c : 0][i] : 0.0f);
        };
        const std::uint16_t four[4] = {value(0), value(1), value(2), half_of(1.0f)};
        std::memcpy(bytes.data() + at_albedo + 8 * i, four, 8);
      }
      const auto put_number = [&](bool there, std::size_t place, const Grid<float>& map) {
        if (there) put(bytes, place + 4 * i, counts ? map[i] : 0.0f);
      };
      put_number(height, at_height, surface.height);
      put_number(normal_sigma, at_normal_sigma, surface.normal_sigma);
      put_number(height_sigma, at_height_sigma, surface.height_sigma);
    }
  });
  return bytes;
}

}  // namespace hada
