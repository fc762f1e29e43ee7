#include "synth/knit_photograph.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/srgb.h"

namespace hada {
namespace {

constexpr float table = 0.02f;  // brightness under the knit
constexpr float ambient = 0.3f, in_the_depth = 0.55f;

// How far each loop lies from where its crossing says.
std::vector<Eigen::Vector2d> unevenness(int loops, double sigma, Seed seed) {
  std::vector<Eigen::Vector2d> shift;
  for (int k = 0; k < loops; ++k) {
    shift.emplace_back(sigma * gaussian(seed, k, 0), sigma * gaussian(seed, k, 1));
  }
  return shift;
}

}  // namespace

Image knit_photograph(const Knit<>& knit, const BentKnit& bent, const Extent& extent, Seed seed,
                      const KnitPhotographOptions& options) {
  const int finer = options.finer;
  const Extent fine{finer * extent.rows, finer * extent.cols, extent.pitch / finer, extent.unit};
  const auto shift = unevenness(int(bent.places.size()), options.unevenness * knit.wale_mm, seed);
  const auto maps =
      seen_from_above(bent_loops(knit, bent, fine, &BentKnit::smooth, shift), knit.yarn_radius_mm,
                      fine.rows, fine.cols, {fine.pitch, fine.pitch}, false);
  const Eigen::Vector3f lamp = Eigen::Vector3f(-0.25f, 0.35f, 0.9f).normalized();
  const double top = knit.loop_depth_mm + knit.yarn_radius_mm;
  Image picture(extent.rows, extent.cols, 3);
  for_each_index(extent.rows, [&](int row) {
    for (int col = 0; col < extent.cols; ++col) {
      Eigen::Array3d sum = Eigen::Array3d::Zero();
      for (int k = 0; k < finer * finer; ++k) {
        const int r = finer * row + k / finer, c = finer * col + k % finer;
        const int stitch = maps.course(r, c);
        if (stitch < 0) {
          sum += table;
          continue;
        }
        const int course = (stitch / bent.wales) % int(knit.colour_repeat.size());
        const auto& yarn = knit.yarns[std::size_t(knit.colour_repeat[std::size_t(course)])];
        const double depth = 0.5 - 0.5 * maps.height(r, c) / top;
        const double shade =
            (ambient + (1.0f - ambient) * std::max(0.0f, maps.normals(r, c).dot(lamp))) *
            (1.0 - in_the_depth * depth) * (1.0 + options.mottle * gaussian(seed + 1, stitch));
        sum += shade * Eigen::Array3d(yarn.red, yarn.green, yarn.blue);
      }
      for (int c = 0; c < 3; ++c) {
        const double noisy =
            sum[c] / (finer * finer) + options.noise * gaussian(seed + 2, row, col, c);
        const float code =
            std::round(255.0f * srgb_from_linear(float(std::clamp(noisy, 0.0, 1.0))));
        picture.planes[std::size_t(c)](row, col) = linear_from_srgb(code / 255.0f);
      }
    }
  });
  return picture;
}

}  // namespace hada
