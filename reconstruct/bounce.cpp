#include "reconstruct/bounce.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr int azimuths = 12;
constexpr double lattice_points = 60000.0;
constexpr float reach = 60.0f;  // points of the lattice, beyond which little is left to see
constexpr float least_rise =
    0.05f;  // of a horizon, 3 degrees: less is an error of the height, and sends little
constexpr float growth = 1.08f;  // of the steps along a direction

// The mean of each square of step x step pixels, over those of the mask.
struct Coarse {
  int rows, cols, step;
  Mask mask;

  Coarse(const Mask& fine, int step_px)
      : rows((fine.rows() + step_px - 1) / step_px),
        cols((fine.cols() + step_px - 1) / step_px),
        step(step_px),
        mask(rows, cols) {
    for_each_index(rows, [&](int row) {
      for (int col = 0; col < cols; ++col) {
        visit(fine, row, col, [&](int, int) { mask(row, col) = 1; });
      }
    });
  }

  template <class Visit>
  void visit(const Mask& fine, int row, int col, const Visit& at) const {
    for (int r = row * step; r < std::min((row + 1) * step, fine.rows()); ++r) {
      for (int c = col * step; c < std::min((col + 1) * step, fine.cols()); ++c) {
        if (fine(r, c)) at(r, c);
      }
    }
  }

  template <class T>
  Grid<T> mean(const Grid<T>& values, const Mask& fine, const T& zero) const {
    Grid<T> means(rows, cols, zero);
    for_each_index(rows, [&](int row) {
      for (int col = 0; col < cols; ++col) {
        T sum = zero;
        float count = 0.0f;
        visit(fine, row, col, [&](int r, int c) {
          sum += values(r, c);
          count += 1.0f;
        });
        if (count > 0.0f) means(row, col) = sum / count;
      }
    });
    return means;
  }
};

// The mean of the channels, the strength of the light divided out.
Grid<float> coarse_grey(const Coarse& coarse, const Image& image, const Light& light,
                        const Mask& mask) {
  Grid<float> grey(coarse.rows, coarse.cols);
  for (int channel = 0; channel < image.channels(); ++channel) {
    const Grid<float>& plane = image.planes[std::size_t(channel)];
    const Grid<float> part = coarse.mean(plane, mask, 0.0f);
    plane.let_go();
    const float scale = float(1.0 / (image.channels() * light.strength[channel]));
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] += scale * part[i];
  }
  return grey;
}

// 1/pi of the integral of (n.w) cos(elevation) from 0 to an elevation of tangent t, per azimuth,
// where n.w = across cos + up sin.
float cosine_integral(float across, float up, float t) {
  const float square = 1.0f + t * t;
  return (0.5f * across * (std::atan(t) + t / square) + 0.5f * up * t * t / square) *
         float(std::numbers::inv_pi);
}

}  // namespace

float Bounce::at(int light, int row, int col) const {
  const Grid<float>& values = gathered[std::size_t(light)];
  const auto place = [&](int pixel, int count) {
    const float at = (float(pixel) + 0.5f) / float(step) - 0.5f;
    return std::clamp(at, 0.0f, float(count - 1));
  };
  const float y = place(row, values.rows());
  const float x = place(col, values.cols());
  const int r = std::min(int(y), std::max(0, values.rows() - 2));
  const int c = std::min(int(x), std::max(0, values.cols() - 2));
  const int below = std::min(r + 1, values.rows() - 1);
  const int right = std::min(c + 1, values.cols() - 1);
  const float v = y - float(r);
  const float u = x - float(c);
  return (1.0f - v) * ((1.0f - u) * values(r, c) + u * values(r, right)) +
         v * ((1.0f - u) * values(below, c) + u * values(below, right));
}

Bounce gather_bounce(const LightStack& stack, const Grid<float>& height, const NormalMap& normals,
                     Grid<float> rho) {
  Bounce bounce;
  Mask mask(rho.rows(), rho.cols());
  double pixels = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = rho[i] > 0.0f;
    pixels += mask[i];
  }
  bounce.rho = std::move(rho);
  bounce.step = std::max(1, int(std::lround(std::sqrt(pixels / lattice_points))));
  const Coarse coarse(mask, bounce.step);
  const float spacing = float(stack.extent().pitch) * float(bounce.step);
  const Grid<float> z = coarse.mean(height, mask, 0.0f);
  const Grid<Eigen::Vector3f> n =
      coarse.mean(normals, mask, Eigen::Vector3f(Eigen::Vector3f::Zero()));
  std::vector<Grid<float>> seen;
  for (std::size_t k = 0; k < stack.lights.size(); ++k) {
    seen.push_back(coarse_grey(coarse, stack.images[k], stack.lights[k], mask));
  }
  bounce.gathered.assign(seen.size(), Grid<float>(coarse.rows, coarse.cols));

  for_each_index(coarse.rows, [&](int row) {
    for (int col = 0; col < coarse.cols; ++col) {
      if (!coarse.mask(row, col)) continue;
      const Eigen::Vector3f normal = n(row, col).normalized();
      for (int a = 0; a < azimuths; ++a) {
        const double azimuth = 2.0 * std::numbers::pi * (a + 0.5) / azimuths;
        const float x = float(std::cos(azimuth));
        const float y = float(std::sin(azimuth));
        const float across = normal.x() * x + normal.y() * y;
        const float plane = -across / normal.z();  // the rise of the tangent plane of the pixel
        float horizon = least_rise;                // above that plane
        float below = cosine_integral(across, normal.z(), plane + horizon);
        for (float way = 1.0f; way < reach; way = std::max(way + 1.0f, way * growth)) {
          const int r = row - int(std::lround(y * way));
          const int c = col + int(std::lround(x * way));
          if (!coarse.mask.contains(r, c)) break;
          if (!coarse.mask(r, c)) continue;
          const float right = spacing * float(c - col);
          const float up = spacing * float(row - r);
          const float over_plane =
              z(r, c) - z(row, col) + (normal.x() * right + normal.y() * up) / normal.z();
          const float rise = over_plane / std::hypot(right, up);
          if (!(rise > horizon)) continue;
          horizon = rise;
          const float above = cosine_integral(across, normal.z(), plane + rise);
          const float factor = (above - below) * float(2.0 * std::numbers::pi / azimuths);
          below = above;
          for (std::size_t k = 0; k < seen.size(); ++k) {
            bounce.gathered[k](row, col) += factor * seen[k](r, c);
          }
        }
      }
    }
  });
  return bounce;
}

}  // namespace hada
