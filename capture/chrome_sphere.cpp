#include "capture/chrome_sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "capture/sphere_geometry.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

// A ray that meets the sphere further out is mirrored towards the table, not towards a light.
constexpr double horizon = 0.7071;

struct DiscPixel {
  int row, col;
  float value;
};

std::vector<DiscPixel> inner_disc(const Grid<float>& grey, const Sphere& sphere) {
  std::vector<DiscPixel> pixels;
  const double reach = horizon * sphere.radius_px;
  const int first_row = std::max(0, int(sphere.center_px.y() - reach));
  const int last_row = std::min(grey.rows() - 1, int(sphere.center_px.y() + reach));
  const int first_col = std::max(0, int(sphere.center_px.x() - reach));
  const int last_col = std::min(grey.cols() - 1, int(sphere.center_px.x() + reach));
  for (int row = first_row; row <= last_row; ++row) {
    for (int col = first_col; col <= last_col; ++col) {
      const Eigen::Vector2d at(col + 0.5, row + 0.5);
      if ((at - sphere.center_px).norm() <= reach) pixels.push_back({row, col, grey(row, col)});
    }
  }
  return pixels;
}

std::vector<float> values_of(const std::vector<DiscPixel>& pixels) {
  std::vector<float> values;
  for (const auto& pixel : pixels) values.push_back(pixel.value);
  return values;
}

std::optional<Eigen::Vector3d> reflected(const SphereInSpace& sphere, const Camera& camera,
                                         double u, double v) {
  const auto seen = mirrored<double>(camera.ray(u, v), sphere.center, sphere.radius);
  if (!seen) return std::nullopt;
  return seen->direction;
}

// The bright pixels that hang together with `peak`.
std::vector<DiscPixel> blob_at(const std::vector<DiscPixel>& disc, const DiscPixel& peak,
                               float level, const Grid<float>& grey) {
  Mask bright(grey.rows(), grey.cols(), 0);
  for (const auto& pixel : disc) bright(pixel.row, pixel.col) = pixel.value >= level;
  std::vector<DiscPixel> blob{peak};
  bright(peak.row, peak.col) = 0;
  for (std::size_t next = 0; next < blob.size(); ++next) {
    const DiscPixel here = blob[next];
    for (int d_row = -1; d_row <= 1; ++d_row) {
      for (int d_col = -1; d_col <= 1; ++d_col) {
        const int row = here.row + d_row;
        const int col = here.col + d_col;
        if (!bright.contains(row, col) || !bright(row, col)) continue;
        bright(row, col) = 0;
        blob.push_back({row, col, grey(row, col)});
      }
    }
  }
  return blob;
}

}  // namespace

std::optional<Highlight> highlight(const Grid<float>& grey, const Mask& saturated,
                                   const Camera& camera, const Sphere& sphere) {
  const auto disc = inner_disc(grey, sphere);
  if (disc.size() < 12) return std::nullopt;
  const float rest = median(values_of(disc));
  const DiscPixel peak = *std::max_element(
      disc.begin(), disc.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  // Halfway up (above the dark reflection of the room) bounds the light's own disc. A small spot is
  // mostly border, so there the partly covered pixels count too.
  const float rise = peak.value - rest;
  auto blob = blob_at(disc, peak, rest + 0.5f * rise, grey);
  constexpr std::size_t small_spot = 40;  // px
  if (blob.size() < small_spot) blob = blob_at(disc, peak, rest + 0.04f * rise, grey);

  const SphereInSpace in_place = in_space(sphere, camera);
  Highlight found;
  found.peak = peak.value;
  found.prominence = double(peak.value) / std::max(double(quantile(values_of(disc), 0.9)), 1e-6);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double total = 0.0;
  std::vector<std::pair<Eigen::Vector3d, double>> seen;
  for (const auto& pixel : blob) {
    const double u = pixel.col + 0.5;
    const double v = pixel.row + 0.5;
    const auto here = reflected(in_place, camera, u, v);
    const auto right = reflected(in_place, camera, u + 0.5, v);
    const auto below = reflected(in_place, camera, u, v + 0.5);
    if (!here || !right || !below) continue;
    const double solid_angle = 4.0 * (*right - *here).cross(*below - *here).norm();
    const double weight = (pixel.value - rest) * solid_angle;
    sum += weight * *here;
    middle += weight * Eigen::Vector2d(u, v);
    total += weight;
    seen.emplace_back(*here, weight);
    found.clipped = found.clipped || saturated(pixel.row, pixel.col);
  }
  if (!(total > 0.0)) return std::nullopt;
  found.direction = sum.normalized();
  found.center_px = middle / total;
  double squares = 0.0;
  for (const auto& [direction, weight] : seen) {
    squares += weight * (direction - found.direction).squaredNorm();
  }
  found.width = std::sqrt(squares / total);
  return found;
}

SphereReading read_chrome_sphere(const Photographs& linear, const Sphere& sphere) {
  SphereReading reading;
  reading.sphere = sphere;
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = linear.images.size();
  std::vector<std::optional<Highlight>> highlights(count);
  for_each_index(int(count), [&](int k) {
    const auto i = std::size_t(k);
    highlights[i] =
        highlight(luminance(linear.images[i]), linear.saturated[i], linear.camera, sphere);
  });
  for (std::size_t k = 0; k < count; ++k) {
    Light light;
    light.image = linear.file.pictures[k].name;
    light.direction_sigma = std::numeric_limits<double>::infinity();
    constexpr double faint = 4.0;  // a highlight must outshine the mirrored room
    const auto& h = highlights[k];
    if (h && h->prominence > faint && h->direction.z() > 0.0) {
      light.direction = h->direction;
      // Half a turn of the normal is a whole turn of the mirrored ray: twice the angle that an
      // error of the circle means, and the middle of the spot to a tenth of its own width.
      // A clipped spot shows only which pixels it touches.
      const double spot_px = h->clipped ? 0.3 : 0.05;
      const double outline_and_spot = 2.0 * std::hypot(sphere.sigma_px, spot_px) / sphere.radius_px;
      light.direction_sigma = std::hypot(outline_and_spot, 0.1 * h->width);
    }
    reading.highlights_px.push_back(h ? h->center_px : Eigen::Vector2d(nowhere, nowhere));
    reading.lights.push_back(light);
  }
  return reading;
}

}  // namespace hada
