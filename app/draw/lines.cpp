#include "app/draw/lines.h"

#include <algorithm>

namespace hada {

using Eigen::Vector2d;

void draw_line(Image& picture, const Vector2d& a, const Vector2d& b, double half,
               const Colour& colour) {
  const Vector2d low = a.cwiseMin(b), high = a.cwiseMax(b), way = b - a;
  for (int r = std::max(0, int(low.y() - half) - 1);
       r <= std::min(picture.rows() - 1, int(high.y() + half) + 1); ++r) {
    for (int c = std::max(0, int(low.x() - half) - 1);
         c <= std::min(picture.cols() - 1, int(high.x() + half) + 1); ++c) {
      const Vector2d p(c + 0.5, r + 0.5);
      const double t = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
      const float share = float(std::clamp(half + 0.5 - (p - a - t * way).norm(), 0.0, 1.0));
      for (std::size_t k = 0; k < 3; ++k) {
        float& value = picture.planes[k](r, c);
        value += share * (colour[k] - value);
      }
    }
  }
}

}  // namespace hada
