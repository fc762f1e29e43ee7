#include "app/draw/crossings_picture.h"

#include "app/draw/lines.h"
#include "core/srgb.h"

namespace hada {
namespace {

constexpr Colour net{0.85f, 0.10f, 0.10f}, dot{1.0f, 0.85f, 0.0f};
constexpr float paleness = 0.35f;

}  // namespace

Image crossings_picture(const Surface& photograph, int wales, const Places& places) {
  const Extent& extent = photograph.extent;
  // Small photographs are enlarged, so that lines stay thinner than yarn.
  const int zoom = std::max(1, 720 / std::max(extent.rows, extent.cols));
  Image picture(zoom * extent.rows, zoom * extent.cols, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& plane =
        photograph.albedo.planes[std::min<std::size_t>(c, photograph.albedo.planes.size() - 1)];
    for (int row = 0; row < picture.rows(); ++row) {
      for (int col = 0; col < picture.cols(); ++col) {
        picture.planes[c](row, col) =
            paleness + (1.0f - paleness) * srgb_from_linear(plane(row / zoom, col / zoom));
      }
    }
  }
  const auto pixel = [&](std::size_t i) -> Eigen::Vector2d {
    const Eigen::Vector2d at = extent.pixel(places[i].head<2>());
    return zoom * Eigen::Vector2d(at[1] + 0.5, at[0] + 0.5);
  };
  const auto join = [&](std::size_t a, std::size_t b) {
    if (places[a].allFinite() && places[b].allFinite()) {
      draw_line(picture, pixel(a), pixel(b), 0.4, net);
    }
  };
  const auto across = std::size_t(wales);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if ((i + 1) % across != 0) join(i, i + 1);
    if (i + across < places.size()) join(i, i + across);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].allFinite()) draw_line(picture, pixel(i), pixel(i), 1.6, dot);
  }
  return picture;
}

}  // namespace hada
