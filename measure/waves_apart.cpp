#include "measure/waves_apart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/bounding_box.h"
#include "core/fft.h"
#include "core/parallel.h"
#include "measure/coarse_map.h"
#include "measure/cubic.h"
#include "measure/response.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_steps = 8.0;    // in a wave, so that the means over blocks tell it
constexpr double widening = 1.3;       // of the plane, so that opposite borders are no neighbours
constexpr double noise_share = 0.02;   // of the deviation of the map: what need not be explained
constexpr double level_share = 100.0;  // of the variance: how far the mean may lie from 0
constexpr int most_rounds = 1500;
constexpr double enough = 1e-4;  // of the map: what is left of it

// Whether a spectrum of the coarse map can be taken: not of a mask that is holes all over.
bool is_wide(const Mask& mask) {
  if (std::find(mask.begin(), mask.end(), 1) == mask.end()) return false;
  const PixelBox box = bounding_box(mask);
  return std::min(box.rows, box.cols) >= fewest_spectrum_pixels;
}

/// The half plane of frequencies of a plane wider than the map.
class Plane {
 public:
  explicit Plane(const CoarseMap& coarse)
      : pitch_(coarse.pitch),
        rows_(fast_length(int(widening * coarse.mask.rows()))),
        cols_(2 * fast_length((int(widening * coarse.mask.cols()) + 1) / 2)) {}

  double size() const { return double(rows_) * cols_; }
  double longest() const { return std::max(rows_, cols_) * pitch_; }
  double area() const { return pitch_ * pitch_; }

  /// f(fx, fy, ordinates that this one stands for) of all frequencies but 0.
  template <class F>
  auto filled(const F& f) const {
    using Value = decltype(f(0.0, 0.0));
    Grid<Value> values(rows_, cols_ / 2 + 1);
    for (int row = 0; row < rows_; ++row) {
      const double fy = -signed_frequency(row, rows_) / (rows_ * pitch_);  // rows run downward
      for (int col = 0; col < values.cols(); ++col) {
        if (row != 0 || col != 0) values(row, col) = f(col / (cols_ * pitch_), fy);
      }
    }
    return values;
  }

  /// What blocks let through of waves.
  double blocks(double fx, double fy) const { return mean_amplitude(fx, fy, pitch_); }

  /// How often the ordinate counts in a sum over the whole plane.
  double times(std::size_t i) const {
    const std::size_t col = i % std::size_t(cols_ / 2 + 1);
    return col == 0 || col == std::size_t(cols_ / 2) ? 1.0 : 2.0;
  }

  Grid<std::complex<double>> transform(const Grid<double>& map) const {
    Grid<double> wide(rows_, cols_);
    for (int row = 0; row < map.rows(); ++row)
      std::copy(map.row(row).begin(), map.row(row).end(), wide.row(row).begin());
    return fft(wide);
  }

  /// The map with that transform, cut to the size of `mask`, and so many times finer.
  Grid<double> map_of(const Grid<std::complex<double>>& transform, const Mask& mask,
                      int finer) const {
    Grid<std::complex<double>> padded(finer * rows_, finer * cols_ / 2 + 1);
    // The first pixel's centre moves towards the border.
    const double moved = 0.5 / finer - 0.5;
    for (int row = 0; row < rows_; ++row) {
      const int i = signed_frequency(row, rows_);
      for (int col = 0; col < transform.cols(); ++col) {
        const double turn = 2.0 * pi * moved * (double(i) / rows_ + double(col) / cols_);
        padded((i + padded.rows()) % padded.rows(), col) =
            transform(row, col) * std::polar(double(finer) * finer, turn);
      }
    }
    return crop(inverse_fft(std::move(padded), finer * cols_), 0, 0, finer * mask.rows(),
                finer * mask.cols());
  }
  /// The same of a product, 0 outside the mask.
  template <class Factor>
  Grid<double> map_of(Grid<std::complex<double>> transform, const Grid<Factor>& factor,
                      const Mask& mask) const {
    for (std::size_t i = 0; i < transform.size(); ++i) transform[i] *= factor[i];
    auto map = crop(inverse_fft(std::move(transform), cols_), 0, 0, mask.rows(), mask.cols());
    for (std::size_t i = 0; i < map.size(); ++i) map[i] *= mask[i];
    return map;
  }

 private:
  double pitch_;
  int rows_, cols_;
};

double dot(const Grid<double>& a, const Grid<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The weights x for which (covariance + noise) x is the map, on the mask. They are sought by
// conjugate gradients, with what would solve it on the whole plane in front: without, the long
// waves take thousands of rounds.
Grid<double> solved(const Plane& plane, const Grid<double>& covariance, double noise,
                    const CoarseMap& coarse) {
  Grid<double> inverse = covariance;
  for (double& value : inverse) value = 1.0 / (value + noise);
  const auto eased = [&](const Grid<double>& map) {
    return plane.map_of(plane.transform(map), inverse, coarse.mask);
  };
  Grid<double> x(coarse.mask.rows(), coarse.mask.cols());
  Grid<double> rest = coarse.height, direction = eased(rest);
  double slope = dot(rest, direction);
  const double aim = enough * enough * dot(rest, rest);
  for (int round = 0; round < most_rounds; ++round) {
    auto image = plane.map_of(plane.transform(direction), covariance, coarse.mask);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] += noise * direction[i];
    const double step = slope / dot(direction, image);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += step * direction[i];
      rest[i] -= step * image[i];
    }
    if (dot(rest, rest) < aim) break;
    const auto next = eased(rest);
    const double slope_there = dot(rest, next);
    for (std::size_t i = 0; i < x.size(); ++i)
      direction[i] = next[i] + slope_there / slope * direction[i];
    slope = slope_there;
  }
  return x;
}

// The transform of one hump's share of the map.
Grid<std::complex<double>> waves_of(const Plane& plane, Grid<std::complex<double>> weights,
                                    const Grid<double>& prior) {
  const auto through = plane.filled([&](double fx, double fy) { return plane.blocks(fx, fy); });
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] *= prior[i] * through[i] / plane.area();
  return weights;
}

// A hump's share of the map.
//
// waves  transform of it
// prior  spectrum of the hump
// told   share of its power that the map tells, by frequency
Waves described(const Plane& plane, const Grid<std::complex<double>>& waves,
                const Grid<double>& prior, const Grid<double>& told, const Mask& mask) {
  const auto f = plane.filled([](double fx, double fy) { return std::hypot(fx, fy); });
  double power = 0.0, moment = 0.0, told_power = 0.0, told_moment = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double weight = plane.times(i) * prior[i];
    power += weight;
    moment += weight * f[i];
    told_power += weight * told[i];
    told_moment += weight * told[i] * f[i];
  }
  const auto map = plane.map_of(waves, mask, 1);
  Waves result{0.0, Grid<float>(map.rows(), map.cols()), moment / power * told_power / told_moment};
  double squares = 0.0, pixels = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    result.map[i] = float(map[i]);
    if (!mask[i]) continue;
    squares += map[i] * map[i];
    pixels += 1.0;
  }
  // Made up for what the map does not tell, in proportion to what was to be expected.
  result.mean_square = squares / pixels * power / told_power;
  return result;
}

// Of all pixels along a side.
std::vector<Cubic> cubics(int pixels, double steps_in_pixel, int steps) {
  std::vector<Cubic> all;
  for (int i = 0; i < pixels; ++i) all.push_back(cubic_at((i + 0.5) * steps_in_pixel - 0.5, steps));
  return all;
}

// Takes the waves with that transform from the map that they are a part of.
void take_off(const Plane& plane, const Grid<std::complex<double>>& waves, const CoarseMap& coarse,
              Grid<float>& map) {
  // 32 steps in the shortest wave: a cubic errs by (2 pi / 32)^4 9 / 384 = 4e-5 of it at most.
  constexpr int most_finer = 4;
  const int finer = std::min(most_finer, coarse.block);
  const auto steps = plane.map_of(waves, coarse.mask, finer);
  const double steps_in_pixel = double(finer) / coarse.block;
  const auto down = cubics(coarse.box.rows, steps_in_pixel, steps.rows());
  const auto across = cubics(coarse.box.cols, steps_in_pixel, steps.cols());
  for_each_index(coarse.box.rows, [&](int row) {
    const auto& [top, weight] = down[std::size_t(row)];
    std::vector<double> line(std::size_t(steps.cols()));
    for (int k = 0; k < 4; ++k) {
      for (int col = 0; col < steps.cols(); ++col)
        line[std::size_t(col)] += weight[std::size_t(k)] * steps(top + k, col);
    }
    for (int col = 0; col < coarse.box.cols; ++col) {
      const Cubic& cubic = across[std::size_t(col)];
      const double* from = line.data() + cubic.first;
      map(coarse.box.row + row, coarse.box.col + col) -=
          float(cubic.weight[0] * from[0] + cubic.weight[1] * from[1] + cubic.weight[2] * from[2] +
                cubic.weight[3] * from[3]);
    }
  });
}

// The spectrum that means over blocks have, and the mean a wide one.
Grid<double> covariance_of(const HumpMixture& mixture, const Plane& plane, double variance) {
  const SpectralGround ground = mixture.ground();
  const std::vector<HumpDensity> humps(mixture.humps.begin(), mixture.humps.end());
  auto covariance = plane.filled([&](double fx, double fy) {
    // A power law has no power at 0; below one wave over the plane it rises no further.
    const double f = std::max(std::hypot(fx, fy), 1.0 / plane.longest());
    double density = ground(std::log(f));
    for (const HumpDensity& hump : humps) density += hump(fx, fy);
    return density * std::pow(plane.blocks(fx, fy), 2) / plane.area();
  });
  covariance(0, 0) = level_share * variance * plane.size();
  return covariance;
}

}  // namespace

WavesApart waves_apart(const Grid<float>& map, const Mask& mask, const Extent& extent,
                       const HumpMixture& mixture) {
  const CoarseMap coarse = coarse_map(map, mask, extent.pitch);
  const auto is_long = [&](const SpectralHump& hump) {
    return std::exp(-hump.log_frequency) >= least_steps * coarse.pitch;
  };
  WavesApart apart{std::vector<std::optional<Waves>>(mixture.humps.size()),
                   {coarse.mask.rows(), coarse.mask.cols(), coarse.pitch, extent.unit},
                   coarse.mask,
                   map};
  if (!is_wide(coarse.mask) || coarse.variance == 0.0 ||
      std::none_of(mixture.humps.begin(), mixture.humps.end(), is_long))
    return apart;
  const Plane plane(coarse);
  const auto covariance = covariance_of(mixture, plane, coarse.variance);
  const double noise = noise_share * noise_share * coarse.variance;
  const auto weights = plane.transform(solved(plane, covariance, noise, coarse));
  Grid<std::complex<double>> taken(weights.rows(), weights.cols());
  for (std::size_t k = 0; k < mixture.humps.size(); ++k) {
    if (!is_long(mixture.humps[k])) continue;
    const HumpDensity hump(mixture.humps[k]);
    const auto prior = plane.filled(hump);
    auto told = plane.filled([&](double fx, double fy) {
      return hump(fx, fy) * std::pow(plane.blocks(fx, fy), 2) / plane.area();
    });
    for (std::size_t i = 0; i < told.size(); ++i) told[i] /= covariance[i] + noise;
    const auto waves = waves_of(plane, weights, prior);
    apart.of_hump[k] = described(plane, waves, prior, told, coarse.mask);
    for (std::size_t i = 0; i < taken.size(); ++i) taken[i] += waves[i];
  }
  take_off(plane, taken, coarse, apart.rest);
  return apart;
}

}  // namespace hada
