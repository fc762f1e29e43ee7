#include "capture/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "capture/chrome_sphere.h"
#include "capture/lamp_colours.h"
#include "capture/sample_mask.h"
#include "capture/sphere_geometry.h"
#include "capture/thrown_light.h"
#include "core/error.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double rim = 0.95;  // of the radius: further out a pixel may be half table
// Enough for errors far below those of the outlines; more would only cost time.
constexpr double most_values = 7000.0;

std::vector<Grid<float>> greys_of(const Photographs& linear,
                                  const std::vector<Eigen::Vector3d>& colours) {
  std::vector<Grid<float>> greys;
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    greys.push_back(luminance(linear.images[k], grey_weight(colours[k])));
  }
  return greys;
}

// Pixels on a square lattice, about `count` of them on an area of `area_px`.
int stride_for(double area_px, double count) {
  return std::max(1, int(std::lround(std::sqrt(area_px / std::max(count, 50.0)))));
}

// The mean over the square of `side` pixels in the middle of which (row, col) lies: light adds up,
// so a mean is as good as a pixel and less noisy. NaN if any of them is saturated.
double mean_around(const Grid<float>& grey, const Mask& saturated, int row, int col, int side) {
  double sum = 0.0;
  int count = 0;
  for (int r = row - side / 2; r < row - side / 2 + side; ++r) {
    for (int c = col - side / 2; c < col - side / 2 + side; ++c) {
      if (!grey.contains(r, c)) continue;
      if (saturated(r, c)) return unknown;
      sum += grey(r, c);
      ++count;
    }
  }
  return sum / count;
}

// The mean of the normals over a square of `side` pixels around the image point `at`.
Eigen::Vector3d mean_normal(const SphereInSpace& sphere, const Camera& camera,
                            const Eigen::Vector2d& at, int side) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const Eigen::Vector2d off(i - 0.5 * (side - 1), j - 0.5 * (side - 1));
      const auto normal = sphere.normal_at(camera, at.x() + off.x(), at.y() + off.y());
      if (normal) sum += *normal;
    }
  }
  return sum / (side * side);
}

MatteEvidence matte_evidence(const Photographs& linear, const std::vector<Grid<float>>& greys,
                             const std::vector<SphereReading>& readings, std::size_t which,
                             double count) {
  const Sphere& sphere = readings[which].sphere;
  const SphereInSpace in_place = in_space(sphere, linear.camera);
  double reach = rim * sphere.radius_px;
  const int stride = stride_for(3.1416 * reach * reach, count);
  reach -= 0.5 * (stride - 1);
  MatteEvidence seen;
  seen.sphere = which;
  seen.values.resize(greys.size());
  std::vector<Hit<double>> hits;
  const Extent& extent = linear.camera.extent;
  for (int row = int(sphere.center_px.y() - reach); row <= sphere.center_px.y() + reach;
       row += stride) {
    for (int col = int(sphere.center_px.x() - reach); col <= sphere.center_px.x() + reach;
         col += stride) {
      // The middle of a square of an even number of pixels lies on their border.
      const double middle = stride % 2 == 0 ? 0.0 : 0.5;
      const Eigen::Vector2d at(col + middle, row + middle);
      if (row < 0 || col < 0 || row >= extent.rows || col >= extent.cols) continue;
      if ((at - sphere.center_px).norm() > reach) continue;
      const Ray ray = linear.camera.ray(at.x(), at.y());
      const auto hit = first_hit<double>(ray, in_place.center, in_place.radius);
      if (!hit) continue;
      seen.rays.push_back(ray);
      seen.places.push_back((at - sphere.center_px) / sphere.radius_px);
      hits.push_back(*hit);
      seen.bends.push_back(mean_normal(in_place, linear.camera, at, stride) - hit->normal);
      for (std::size_t k = 0; k < greys.size(); ++k) {
        // A sphere that is not lit like one in a picture has nothing to say of its light.
        const bool lit = std::isfinite(readings[which].lights[k].direction_sigma);
        seen.values[k].push_back(lit ? mean_around(greys[k], linear.saturated[k], row, col, stride)
                                     : unknown);
      }
    }
  }
  std::vector<Sphere> spheres;
  for (const auto& reading : readings) spheres.push_back(reading.sphere);
  seen.thrown = thrown_light(greys, linear.camera, spheres, hits);
  return seen;
}

bool says_anything(const MatteEvidence& seen) {
  return std::any_of(seen.values.begin(), seen.values.end(), [](const auto& values) {
    return std::any_of(values.begin(), values.end(), [](double v) { return !std::isnan(v); });
  });
}

// How bright the sample is in a picture, so that weak lamps are not taken for shadows.
double level_of(const Grid<float>& grey, const Mask& mask) {
  std::vector<float> values;
  const std::size_t stride = 1 + mask.size() / 20000;
  for (std::size_t i = 0; i < mask.size(); i += stride) {
    if (mask[i]) values.push_back(grey[i]);
  }
  return values.empty() ? 1.0 : std::max(double(median(std::move(values))), 1e-9);
}

void add_chrome(const Photographs& linear, const std::vector<SphereReading>& readings,
                std::size_t which, std::vector<ChromeEvidence>& evidence) {
  const SphereReading& reading = readings[which];
  const SphereInSpace in_place = in_space(reading.sphere, linear.camera);
  for (std::size_t k = 0; k < reading.lights.size(); ++k) {
    if (!std::isfinite(reading.lights[k].direction_sigma)) continue;
    const Eigen::Vector2d at = reading.highlights_px[k];
    ChromeEvidence seen{which, k, linear.camera.ray(at.x(), at.y()), Eigen::Vector3d::Zero(), 0.0};
    const auto middle = mirrored<double>(seen.ray, in_place.center, in_place.radius);
    if (!middle) continue;
    seen.offset = reading.lights[k].direction - middle->direction;
    // The reading's sigma holds the outline's share, which the joint fit treats by itself.
    const double outline = 2.0 * reading.sphere.sigma_px / reading.sphere.radius_px;
    const double sigma = reading.lights[k].direction_sigma;
    seen.sigma = std::sqrt(std::max(sigma * sigma - outline * outline, 1e-8));
    evidence.push_back(seen);
  }
}

Eigen::Vector3d middle_of(const Mask& mask, const Extent& extent) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      sum.head<2>() += extent.place(row, col);
      count += 1.0;
    }
  }
  return sum / count;
}

SheetEvidence sheet_evidence(const Photographs& linear, const std::vector<Grid<float>>& greys,
                             const Mask& mask, double count) {
  SheetEvidence sheet;
  const auto area = std::count(mask.begin(), mask.end(), 1);
  if (area == 0) return sheet;
  const int stride = stride_for(double(area), count);
  std::vector<double> level;
  for (const auto& grey : greys) {
    level.push_back(level_of(grey, mask));
    grey.let_go();
  }
  const int side = std::min(3, stride) / 2 * 2 + 1;  // shadows are narrow
  for (int row = stride / 2; row < mask.rows(); row += stride) {
    for (int col = stride / 2; col < mask.cols(); col += stride) {
      if (!mask(row, col)) continue;
      std::vector<double> values;
      for (std::size_t k = 0; k < greys.size(); ++k) {
        values.push_back(mean_around(greys[k], linear.saturated[k], row, col, side));
      }
      // What is far darker than the rest lies in a shadow, which a matte sheet cannot explain.
      std::vector<double> relative;
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (!std::isnan(values[k])) relative.push_back(values[k] / level[k]);
      }
      if (relative.empty()) continue;
      const double dark = 0.15 * median(std::move(relative));
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] < dark * level[k]) values[k] = unknown;
      }
      const auto known = std::count_if(values.begin(), values.end(),
                                       [](double value) { return !std::isnan(value); });
      if (known < 4) continue;  // albedo and normal take three
      const Eigen::Vector2d place = linear.camera.extent.place(row, col);
      sheet.points.emplace_back(place.x(), place.y(), 0.0);
      sheet.values.push_back(std::move(values));
    }
  }
  return sheet;
}

Mask sheet_mask(const Photographs& linear, const std::vector<Grid<float>>& greys,
                const std::vector<SphereReading>& readings) {
  std::vector<Sphere> spheres;
  for (const auto& reading : readings) spheres.push_back(reading.sphere);
  if (!linear.mask.empty()) {
    // The mask of a folder of a ball alone is the ball: no sample beside it.
    const auto at = spheres.front().center_px;
    const bool is_ball = linear.mask(int(at.y()), int(at.x())) != 0;
    return is_ball ? Mask(linear.mask.rows(), linear.mask.cols(), 0) : linear.mask;
  }
  Grid<float> mean(greys[0].rows(), greys[0].cols());
  for (const auto& grey : greys) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += grey[i] / float(greys.size());
    grey.let_go();
  }
  return sample_mask(mean, spheres, linear.file.sample_box);
}

// Without a sample only matte spheres tell strengths: one of them must be lit in every picture.
void check_strengths(const Photographs& linear, const std::vector<SphereReading>& readings) {
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    const bool told = std::any_of(readings.begin(), readings.end(), [&](const auto& reading) {
      return reading.sphere.kind == SphereKind::matte &&
             std::isfinite(reading.lights[k].direction_sigma);
    });
    if (told) continue;
    throw Error(linear.file.pictures[k].file.string() +
                ": no matte sphere is well lit there, and there is no sample that could tell how "
                "strong the light is; leave the picture out or light the sphere");
  }
}

}  // namespace

Evidence evidence(const Photographs& linear, const std::vector<SphereReading>& readings,
                  const std::vector<Eigen::Vector3d>& colours, bool ask_sample) {
  const auto greys = greys_of(linear, colours);
  const double count = std::min(700.0, most_values / double(greys.size()));
  Evidence all;
  for (std::size_t which = 0; which < readings.size(); ++which) {
    if (readings[which].sphere.kind == SphereKind::matte) {
      auto seen = matte_evidence(linear, greys, readings, which, count);
      if (says_anything(seen)) all.matte.push_back(std::move(seen));
    } else {
      add_chrome(linear, readings, which, all.chrome);
    }
  }
  const Mask mask = sheet_mask(linear, greys, readings);
  constexpr std::size_t fewest_lights = 5;  // with four and less a sheet agrees to nearly anything
  const bool has_sample = std::any_of(mask.begin(), mask.end(), [](auto m) { return m != 0; });
  if (ask_sample && has_sample && greys.size() >= fewest_lights) {
    all.sheet = sheet_evidence(linear, greys, mask, count);
  }
  if (has_sample) all.sheet.center = middle_of(mask, linear.camera.extent);
  if (all.sheet.points.empty() && !all.matte.empty()) check_strengths(linear, readings);
  return all;
}

}  // namespace hada
