#include "reconstruct/labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/parallel.h"
#include "reconstruct/tile_source.h"

namespace hada {
namespace {

constexpr double certain = 4.0;            // sigma
constexpr double shadow_depth = 0.2;       // of the prediction; penumbra and bounce make less
constexpr double highlight_height = 0.05;  // of the albedo; departures from Lambert make less
constexpr std::size_t label_count = 6;

Sample label(double value, double predicted, double rho, double sigma) {
  if (predicted <= 0.0) return Sample::attached_shadow;
  const double more = value - predicted;
  if (more < -std::max(certain * sigma, shadow_depth * predicted)) return Sample::cast_shadow;
  if (more > std::max(certain * sigma, highlight_height * rho)) return Sample::highlight;
  return Sample::lit;
}

}  // namespace

std::vector<Grid<Sample>> label_samples(const LightStack& stack, const Orientation& found,
                                        const NormalOptions& options) {
  const TileSource source = source_of(stack, options);
  std::vector<Grid<Sample>> labels = stack.samples;
  for_slices(stack.extent().rows, [&](int begin, int end) {
    Tile tile = source.tile(stack.extent().cols, true);
    std::vector<float> shading;
    for (int row = begin; row < end; ++row) {
      source.fill(tile, 0, row, 0, tile.pixels);
      for (int col = 0; col < tile.pixels; ++col) {
        const auto i = std::size_t(col);
        const float rho = found.mask(row, col) ? found.rho(row, col) : 0.0f;
        const Eigen::Vector3f scaled = rho * found.normals(row, col);
        tile.x[i] = scaled.x();
        tile.y[i] = scaled.y();
        tile.z[i] = scaled.z();
      }
      shading_of(tile, found.terms, shading);
      for (int col = 0; col < tile.pixels; ++col) {
        if (!found.mask(row, col)) continue;
        const double rho = found.rho(row, col);
        for (int k = 0; k < tile.lights; ++k) {
          Sample& sample = labels[std::size_t(k)](row, col);
          if (sample == Sample::saturated) continue;
          const std::size_t j = tile.near ? tile.at(k, col) : std::size_t(k);
          const Eigen::Vector3f l(tile.x_to[j], tile.y_to[j], tile.z_to[j]);
          const bool facing = found.normals(row, col).dot(l) > 0.0f;
          const double predicted = facing ? rho * shading[tile.at(k, col)] : 0.0;
          sample = label(tile.raw[tile.at(k, col)], predicted, rho, found.noise);
        }
      }
    }
  });
  return labels;
}

std::vector<double> label_shares(const std::vector<Grid<Sample>>& labels, const Mask& mask) {
  std::vector<double> counts(label_count, 0.0);
  double all = 0.0;
  for (const Grid<Sample>& picture : labels) {
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (!mask[i]) continue;
      counts[std::size_t(picture[i])] += 1.0;
      all += 1.0;
    }
  }
  for (double& count : counts) count /= std::max(all, 1.0);
  return counts;
}

}  // namespace hada
