#include "app/draw/maps.h"

#include <algorithm>
#include <cmath>

#include "app/draw/palette.h"
#include "core/parallel.h"
#include "io/image_file.h"

namespace hada {
namespace {

// Outside the mask: a grey that neither a light nor a dark page mistakes for data.
constexpr Colour nothing{0.5f, 0.5f, 0.5f};

template <class ColourAt>
Image painted(const Mask& mask, const ColourAt& colour_at) {
  Image picture(mask.rows(), mask.cols(), 3);
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      const Colour colour = mask(row, col) ? colour_at(row, col) : nothing;
      for (std::size_t c = 0; c < 3; ++c) picture.planes[c](row, col) = colour[c];
    }
  });
  return picture;
}

const NormalMap& normals_in(const Surface& surface, NormalMap& made) {
  if (!surface.normals.empty()) return surface.normals;
  made = normals_of(surface.height, surface.mask, surface.extent.pitch);
  return made;
}

double share_in(Range range, double value) {
  return (value - range.low) / (range.high - range.low);
}

}  // namespace

Range range_of(const Grid<float>& values, const Mask& mask, double tail) {
  std::vector<float> inside;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mask[i] && std::isfinite(values[i])) inside.push_back(values[i]);
  }
  if (inside.empty()) return {};
  const auto quantile = [&](double share) {
    const auto nth = inside.begin() + std::ptrdiff_t(share * double(inside.size() - 1));
    std::nth_element(inside.begin(), nth, inside.end());
    return double(*nth);
  };
  const Range range{quantile(tail), quantile(1.0 - tail)};
  const double least = 1e-6 * std::max(1e-6, std::abs(range.low));
  return range.high - range.low > least ? range : Range{range.low - least, range.low + least};
}

ReliefStyle relief_style(const Surface& surface) {
  NormalMap made;
  const NormalMap& normals = normals_in(surface, made);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!surface.mask[i]) continue;
    const double z = normals[i].z();
    sum += (1.0 - z * z) / (z * z);
    count += 1.0;
  }
  constexpr double visible_slope = 0.45;
  const double slope = std::sqrt(sum / std::max(1.0, count));
  return {range_of(surface.height, surface.mask),
          std::clamp(visible_slope / std::max(slope, 1e-9), 1.0, 100.0)};
}

Image relief_picture(const Surface& surface, const ReliefStyle& style) {
  NormalMap made;
  const NormalMap& normals = normals_in(surface, made);
  const Eigen::Vector3d light = Eigen::Vector3d(-1.0, 1.0, 1.6).normalized();
  return painted(surface.mask, [&](int row, int col) {
    const Eigen::Vector3d n = normals(row, col).cast<double>();
    const double steep = style.exaggeration / n.z();
    const double facing =
        Eigen::Vector3d(steep * n.x(), steep * n.y(), 1.0).normalized().dot(light);
    const double shade = 0.25 + 0.9 * std::max(0.0, facing);
    Colour colour = sequential(share_in(style.height, surface.height(row, col)));
    for (float& value : colour) value = float(std::clamp(value * shade, 0.0, 1.0));
    return colour;
  });
}

Image normal_picture(const Surface& surface) {
  NormalMap made;
  const NormalMap& normals = normals_in(surface, made);
  return painted(surface.mask, [&](int row, int col) {
    const Eigen::Vector3f half = 0.5f * (normals(row, col) + Eigen::Vector3f::Ones());
    return Colour{half.x(), half.y(), half.z()};
  });
}

Image albedo_picture(const Surface& surface) {
  const Image& albedo = surface.albedo;
  // A sheet of one tone is drawn as light grey, not as a part of the page.
  constexpr double headroom = 1.25;
  const double white =
      headroom * std::max(1e-9, range_of(luminance(albedo), surface.mask, 0.005).high);
  return painted(surface.mask, [&](int row, int col) {
    Colour colour;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = albedo.planes[albedo.channels() < 3 ? 0 : c](row, col);
      colour[c] = srgb_from_linear(float(std::clamp(value / white, 0.0, 1.0)));
    }
    return colour;
  });
}

Image scalar_picture(const Grid<float>& values, const Mask& mask, Range range) {
  return painted(mask, [&](int row, int col) {
    return std::isfinite(values(row, col)) ? sequential(share_in(range, values(row, col)))
                                           : nothing;
  });
}

Image shrunk(const Image& picture, int most_px) {
  const int step = (std::max(picture.rows(), picture.cols()) + most_px - 1) / most_px;
  if (step <= 1) return picture;
  const int rows = std::max(1, picture.rows() / step);
  const int cols = std::max(1, picture.cols() / step);
  Image small(rows, cols, picture.channels());
  for (std::size_t c = 0; c < small.planes.size(); ++c) {
    for_each_index(rows, [&](int row) {
      for (int col = 0; col < cols; ++col) {
        double sum = 0.0;
        int count = 0;
        for (int r = row * step; r < std::min((row + 1) * step, picture.rows()); ++r) {
          for (int k = col * step; k < std::min((col + 1) * step, picture.cols()); ++k, ++count) {
            sum += picture.planes[c](r, k);
          }
        }
        small.planes[c](row, col) = float(sum / count);
      }
    });
  }
  return small;
}

Surface shrunk(const Surface& surface, int most_px) {
  const Extent& whole = surface.extent;
  const int step = std::max(1, (std::max(whole.rows, whole.cols) + most_px - 1) / most_px);
  Surface small;
  small.extent = whole;
  small.extent.rows = std::max(1, whole.rows / step);
  small.extent.cols = std::max(1, whole.cols / step);
  small.extent.pitch *= step;
  small.mask = Mask(small.extent.rows, small.extent.cols, 0);
  if (surface.has_height()) small.height = Grid<float>(small.extent.rows, small.extent.cols);
  if (!surface.normals.empty()) {
    small.normals = NormalMap(small.extent.rows, small.extent.cols, Eigen::Vector3f::UnitZ());
  }
  for_each_index(small.extent.rows, [&](int row) {
    for (int col = 0; col < small.extent.cols; ++col) {
      double height = 0.0;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      int count = 0;
      for (int r = row * step; r < std::min((row + 1) * step, whole.rows); ++r) {
        for (int c = col * step; c < std::min((col + 1) * step, whole.cols); ++c) {
          if (!surface.mask(r, c)) continue;
          ++count;
          if (surface.has_height()) height += surface.height(r, c);
          if (!surface.normals.empty()) normal += surface.normals(r, c).cast<double>();
        }
      }
      if (count == 0) continue;
      small.mask(row, col) = 1;
      if (surface.has_height()) small.height(row, col) = float(height / count);
      if (!surface.normals.empty()) small.normals(row, col) = normal.normalized().cast<float>();
    }
  });
  return small;
}

Image thumbnail(const Image& photograph, bool linear, int most_px) {
  Image small = shrunk(photograph, most_px);
  if (!linear) return small;
  for (auto& plane : small.planes) {
    for (float& value : plane) value = srgb_from_linear(std::clamp(value, 0.0f, 1.0f));
  }
  return small;
}

}  // namespace hada
