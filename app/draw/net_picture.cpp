#include "app/draw/net_picture.h"

#include <algorithm>
#include <cmath>

#include "app/draw/lettering.h"
#include "app/draw/lines.h"
#include "app/draw/palette.h"
#include "mechanics/worn_knit.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr Colour paper{1.0f, 1.0f, 1.0f}, ink{0.05f, 0.05f, 0.05f};
constexpr Colour nylon{0.35f, 0.62f, 0.80f}, support{0.10f, 0.16f, 0.33f},
    held{0.90f, 0.45f, 0.10f};
constexpr int margin = 34;
constexpr double half_width_px = 0.9, point_px = 3.2;

}  // namespace

Image net_picture(const KnitNet& net, const std::vector<Places>& states, int rows) {
  Eigen::Vector3d low = states[0][0], high = low;
  for (const Places& places : states) {
    for (const auto& p : places) low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  const double width = high.x() - low.x(), height = high.y() - low.y();
  const double pitch = std::max(height / (rows - 2 * margin), width / 900.0);
  const int across = int(width / pitch) + 2 * margin, down = int(height / pitch) + 2 * margin;
  Image picture(down, across * int(states.size()), 3);
  fill_box(picture, 0, 0, down, picture.cols(), paper);
  for (std::size_t s = 0; s < states.size(); ++s) {
    const auto pixel = [&](int i) {
      const auto& p = states[s][std::size_t(i)];
      return Vector2d(margin + double(s) * across + (p.x() - low.x()) / pitch,
                      margin + (high.y() - p.y()) / pitch);
    };
    for (const auto& line : springs_of(net)) {
      const bool supports = net.stiffness[std::size_t(line.from / net.wales)] > 1.0;
      draw_line(picture, pixel(line.from), pixel(line.to), half_width_px,
                supports ? support : nylon);
    }
    for (int i = 0; i < net.points(); ++i) {
      if (net.is_pinned(i)) draw_line(picture, pixel(i), pixel(i), point_px, held);
    }
  }
  draw_scale_bar(picture, pitch, ink);
  return picture;
}

}  // namespace hada
