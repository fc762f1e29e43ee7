#include "reconstruct/tile_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <Eigen/Geometry>

#include "reconstruct/normals.h"

namespace hada {
namespace {

// Light of strength 1 that arrives: unit direction and fall-off.
struct Arrival {
  Eigen::Vector3d direction;
  double falloff;
};

Arrival arrival(const Light& light, const Eigen::Vector3d& point) {
  Light unit = light;
  unit.strength.setOnes();
  const Eigen::Vector3d arrives = arriving(unit, 0, point);
  const double falloff = arrives.norm();
  return {arrives / falloff, falloff};
}

// The samples after these are those of the next tile: their memory answers while this one is
// solved.
void fetch_next(const float* values, int count) {
  constexpr int line_pixels = 16;
  for (int i = 0; i < count; i += line_pixels) __builtin_prefetch(values + count + i, 0, 2);
}

bool all_lit(std::span<const Sample> samples) {
  std::uint8_t found = 0;
  for (const Sample sample : samples) found |= std::uint8_t(sample);
  return found == std::uint8_t(Sample::lit);
}

void put(Tile& tile, int light, int pixel, const Eigen::Vector3d& direction) {
  const std::size_t i = tile.near ? tile.at(light, pixel) : std::size_t(light);
  tile.x_to[i] = float(direction.x());
  tile.y_to[i] = float(direction.y());
  tile.z_to[i] = float(direction.z());
}

Eigen::Vector3d point_at(const TileSource& source, int row, int col) {
  const Eigen::Vector2d place = source.stack.extent().place(row, col);
  return {place.x(), place.y(), source.height ? double((*source.height)(row, col)) : 0.0};
}

}  // namespace

bool TileSource::near() const {
  return std::any_of(stack.lights.begin(), stack.lights.end(),
                     [](const Light& light) { return light.position.has_value(); });
}

Tile TileSource::tile(int most_pixels, bool keep_raw) const {
  Tile tile(int(stack.lights.size()), most_pixels, near());
  if (keep_raw || bounce) tile.raw = tile.grey;
  if (bounce) tile.bounce = tile.grey;
  if (!tile.near) {
    for (int k = 0; k < tile.lights; ++k) {
      put(tile, k, 0, stack.lights[std::size_t(k)].direction.normalized());
    }
  }
  return tile;
}

bool TileSource::fill(Tile& tile, int first, int row, int col, int count) const {
  bool all_trusted = true;
  for (int k = 0; k < tile.lights; ++k) {
    const auto light = std::size_t(k);
    const Image& image = stack.images[light];
    const std::size_t begin = tile.at(k, first);
    float* grey = &tile.grey[begin];
    for (int channel = 0; channel < image.channels(); ++channel) {
      const float weight = image.channels() == 1 ? 1.0f : channel_weight[channel];
      const float scale = float(double(weight) / stack.lights[light].strength[channel]);
      const float* values = image.planes[std::size_t(channel)].row(row).data() + col;
      fetch_next(values, count);
      if (channel == 0) {
        for (int i = 0; i < count; ++i) grey[i] = scale * values[i];
      } else {
        for (int i = 0; i < count; ++i) grey[i] += scale * values[i];
      }
    }
    const auto samples =
        stack.samples[light].row(row).subspan(std::size_t(col), std::size_t(count));
    float* trust = &tile.trust[begin];
    if (all_count || all_lit(samples)) {
      if (!tile.trusts_all) std::fill(trust, trust + count, 1.0f);
    } else {
      all_trusted = false;
      tile.trusts_all = false;
      for (int i = 0; i < count; ++i) {
        trust[i] = samples[std::size_t(i)] == Sample::lit ? 1.0f : 0.0f;
      }
    }
    if (tile.near) {
      for (int i = 0; i < count; ++i) {
        const auto [direction, falloff] =
            arrival(stack.lights[light], point_at(*this, row, col + i));
        put(tile, k, first + i, direction);
        tile.closeness[begin + std::size_t(i)] = float(std::sqrt(falloff));
        grey[i] = float(grey[i] / falloff);
      }
    }
    if (!tile.raw.empty()) std::copy(grey, grey + count, &tile.raw[begin]);
    if (bounce) {
      for (int i = 0; i < count; ++i) {
        const float rho = bounce->rho(row, col + i);
        float value = rho > 0.0f ? rho * bounce->at(k, row, col + i) : 0.0f;
        if (tile.near) {
          value =
              float(value / arrival(stack.lights[light], point_at(*this, row, col + i)).falloff);
        }
        tile.bounce[begin + std::size_t(i)] = value;
      }
    }
  }
  if (all_trusted && count == tile.stride) tile.trusts_all = true;
  return all_trusted;
}

void TileSource::let_go(int begin, int end) const {
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    stack.images[k].let_go(begin, end);
    stack.samples[k].let_go(begin, end);
  }
}

bool TileSource::reads_directly() const {
  return stack.images.front().channels() == 1 && !near();
}

void TileSource::point_at_row(int row, int col, GreyRows& rows) const {
  rows.values.clear();
  rows.scale.clear();
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    rows.values.push_back(stack.images[k].planes[0].row(row).data() + col);
    rows.scale.push_back(float(1.0 / stack.lights[k].strength[0]));
  }
}

void TileSource::fill_channel(const Tile& tile, int channel, int row, int col,
                              std::vector<float>& values) const {
  values.resize(tile.grey.size());
  for (int k = 0; k < tile.lights; ++k) {
    const auto light = std::size_t(k);
    const float scale = float(1.0 / stack.lights[light].strength[channel]);
    const float* from = stack.images[light].planes[std::size_t(channel)].row(row).data() + col;
    float* to = &values[tile.at(k, 0)];
    for (int i = 0; i < tile.pixels; ++i) to[i] = scale * from[i];
    if (!tile.near) continue;
    for (int i = 0; i < tile.pixels; ++i) {
      to[i] = float(to[i] / arrival(stack.lights[light], point_at(*this, row, col + i)).falloff);
    }
  }
}

TileSource source_of(const LightStack& stack, const NormalOptions& options) {
  TileSource source{.stack = stack};
  const bool mean_of_channels =
      options.estimator == Estimator::biweight || options.estimator == Estimator::adaptive;
  if (stack.images.front().channels() > 1) {
    for (int channel = 0; channel < 3; ++channel) {
      source.channel_weight[channel] = mean_of_channels ? 1.0f / 3.0f : luminance_weight[channel];
    }
  }
  source.all_count = options.estimator == Estimator::least_squares;
  source.height = options.height;
  if (options.estimator == Estimator::adaptive) source.bounce = options.bounce;
  return source;
}

}  // namespace hada
