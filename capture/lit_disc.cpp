#include "capture/lit_disc.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "capture/matte_sphere.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

// The mean grey value of a picture without the disc of the sphere.
double mean_beside(const Grid<float>& grey, const Sphere& sphere) {
  double sum = 0.0;
  double count = 0.0;
  const double reach = sphere.radius_px + 1.0;
  for (int row = 0; row < grey.rows(); ++row) {
    for (int col = 0; col < grey.cols(); ++col) {
      const Eigen::Vector2d off = Eigen::Vector2d(col + 0.5, row + 0.5) - sphere.center_px;
      if (off.squaredNorm() < reach * reach) continue;
      sum += grey(row, col);
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

std::vector<LitDisc> lit_discs(const Photographs& linear, const Sphere& sphere) {
  const std::size_t count = linear.images.size();
  std::vector<LitDisc> discs(count);
  std::vector<double> strengths(count), misfits(count), beside(count);
  for_each_index(int(count), [&](int picture) {
    const auto k = std::size_t(picture);
    const Grid<float> grey = luminance(linear.images[k]);
    const MatteShading shading = matte_shading(grey, linear.saturated[k], linear.camera, sphere);
    strengths[k] = shading.b.norm();
    misfits[k] = shading.misfit;
    beside[k] = mean_beside(grey, sphere);
  });
  constexpr double too_dark = 0.1;          // of what most pictures show
  constexpr double levels = 16.0;           // fewer, and a step of the file is more than 6 %
  constexpr double odd = 0.3;               // of the contrast unexplained: a shadow, not a texture
  constexpr double odder_than_usual = 2.5;  // times what is unexplained in most pictures
  constexpr double in_shadow = 0.25;        // of what the picture around it lets expect
  const double step = linear.bits <= 16 ? 1.0 / ((1 << linear.bits) - 1.0) : 0.0;
  const double usual = median(strengths);
  const double usual_beside = median(beside);
  const double dark = std::max(too_dark * usual, levels * step);
  const double uneven = std::max(odd, odder_than_usual * median(misfits));
  for (std::size_t k = 0; k < count; ++k) {
    discs[k] = {strengths[k], misfits[k], DiscLight::good};
    if (strengths[k] < dark) {
      const bool alone = strengths[k] * usual_beside < in_shadow * usual * beside[k];
      discs[k].light = alone ? DiscLight::shadowed : DiscLight::weak;
    } else if (misfits[k] > uneven) {
      discs[k].light = DiscLight::odd;
    }
  }
  return discs;
}

void leave_out_shadowed(const Photographs& linear, std::vector<SphereReading>& readings) {
  std::vector<std::vector<LitDisc>> discs(readings.size());
  for (std::size_t s = 0; s < readings.size(); ++s) {
    if (readings[s].sphere.kind == SphereKind::matte) {
      discs[s] = lit_discs(linear, readings[s].sphere);
    }
  }
  const auto believed = [&](std::size_t s, std::size_t k) {
    return is_seen(readings[s].lights[k]) &&
           (discs[s].empty() || discs[s][k].light == DiscLight::good);
  };
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    bool seen_well = false;
    for (std::size_t s = 0; s < readings.size(); ++s) seen_well = seen_well || believed(s, k);
    for (std::size_t s = 0; s < readings.size(); ++s) {
      if (discs[s].empty()) continue;
      const DiscLight light = discs[s][k].light;
      if (light == DiscLight::shadowed || (light == DiscLight::odd && seen_well)) {
        readings[s].lights[k].direction_sigma = std::numeric_limits<double>::infinity();
      }
    }
  }
}

}  // namespace hada
