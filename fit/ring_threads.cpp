#include "fit/ring_threads.h"

#include <cmath>

#include "measure/line_field.h"

namespace hada {
namespace {

// Of the distance of rings: Gaussians of the structure tensor, and the length of a thread.
constexpr double gradient_share = 0.12, window_share = 0.4, length_share = 1.0;
constexpr double least_gradient_px = 1.5, least_window_px = 4.0;
constexpr float least_coherence = 0.3f;

/// Where a line leads that starts at `place` (x right, y up, px from the middle), `steps` of a px.
/// false if its direction is not known on the way.
bool followed(const LineField& field, const Extent& extent, Eigen::Vector2d& place,
              Eigen::Vector2d way, int steps) {
  for (int step = 0; step < steps; ++step) {
    const Eigen::Vector2d pixel = extent.pixel(place);
    const int row = int(std::lround(pixel.x())), col = int(std::lround(pixel.y()));
    if (!field.contains(row, col) || field.coherence(row, col) < least_coherence) return false;
    const double across = double(field.across(row, col));
    Eigen::Vector2d along(-std::sin(across), std::cos(across));
    if (along.dot(way) < 0.0) along = -along;
    way = along;
    place += extent.pitch * along;
  }
  return true;
}

}  // namespace

std::vector<RingThread> ring_threads(const BlockFace& face, std::size_t index, double ring_px) {
  const LineField field =
      line_field(face.absorbance, face.wood,
                 {.gradient_px = std::max(least_gradient_px, gradient_share * ring_px),
                  .window_px = std::max(least_window_px, window_share * ring_px)});
  const int step = std::max(4, int(std::lround(length_share * ring_px)));
  std::vector<RingThread> threads;
  for (int row = step / 2; row < face.extent.rows; row += step) {
    for (int col = step / 2; col < face.extent.cols; col += step) {
      if (field.coherence(row, col) < least_coherence) continue;
      const double across = double(field.across(row, col));
      const Eigen::Vector2d normal(std::cos(across), std::sin(across)),
          along(-normal.y(), normal.x());
      Eigen::Vector2d from = face.extent.place(row, col), to = from;
      if (!followed(field, face.extent, from, -along, step / 2) ||
          !followed(field, face.extent, to, along, step / 2))
        continue;
      StemVector direction;
      for (std::size_t k = 0; k < 3; ++k)
        direction[k] = normal.x() * face.cut.right[k] + normal.y() * face.cut.up[k];
      threads.push_back(
          {face.cut.at(from.x(), from.y()), face.cut.at(to.x(), to.y()), index, direction});
    }
  }
  return threads;
}

}  // namespace hada
