#include "measure/waves_apart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/bounding_box.h"
#include "core/fft.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int steps_across = 128;      // of the coarse map
constexpr int fewest_steps = 16;       // over the shorter side
constexpr double least_steps = 8.0;    // in a wave, so that the means over blocks tell it
constexpr double widening = 1.3;       // of the plane, so that opposite borders are no neighbours
constexpr double noise_share = 0.02;   // of the deviation of the map: what need not be explained
constexpr double level_share = 100.0;  // of the variance: how far the mean may lie from 0
constexpr int most_rounds = 1500;
constexpr double enough = 1e-4;  // of the map: what is left of it

/// Means over square blocks.
struct CoarseMap {
  PixelBox box;  // of the map that it covers
  int block = 1;
  Grid<double> height;  // about its mean; 0 outside the mask
  Mask mask;
  double pitch = 0.0;
  double variance = 0.0;
};

CoarseMap coarse_map(const Grid<float>& map, const Mask& mask, double pitch) {
  const PixelBox box = bounding_box(mask);
  const int longer = std::max(box.rows, box.cols), shorter = std::min(box.rows, box.cols);
  const int block =
      std::max(1, std::min((longer + steps_across - 1) / steps_across, shorter / fewest_steps));
  const int rows = (box.rows + block - 1) / block, cols = (box.cols + block - 1) / block;
  CoarseMap coarse{box, block, Grid<double>(rows, cols), Mask(rows, cols, 0), block * pitch};
  double sum = 0.0, count = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      double inside = 0.0, pixels = 0.0;
      for (int y = row * block; y < std::min((row + 1) * block, box.rows); ++y) {
        for (int x = col * block; x < std::min((col + 1) * block, box.cols); ++x) {
          if (!mask(box.row + y, box.col + x)) continue;
          inside += map(box.row + y, box.col + x);
          pixels += 1.0;
        }
      }
      if (2.0 * pixels < double(block) * block) continue;
      coarse.mask(row, col) = 1;
      coarse.height(row, col) = inside / pixels;
      sum += coarse.height(row, col);
      count += 1.0;
    }
  }
  for (std::size_t i = 0; i < coarse.mask.size(); ++i) {
    if (!coarse.mask[i]) continue;
    coarse.height[i] -= sum / count;
    coarse.variance += coarse.height[i] * coarse.height[i] / count;
  }
  return coarse;
}

// Whether a spectrum of the coarse map can be taken: not of a mask that is holes all over.
bool is_wide(const Mask& mask) {
  constexpr int least = 8;
  if (std::find(mask.begin(), mask.end(), 1) == mask.end()) return false;
  const PixelBox box = bounding_box(mask);
  return std::min(box.rows, box.cols) >= least;
}

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1.0 : std::sin(pi * x) / (pi * x);
}

/// The half plane of frequencies of a plane wider than the map.
class Plane {
 public:
  Plane(const CoarseMap& coarse)
      : pitch_(coarse.pitch),
        rows_(cv::getOptimalDFTSize(int(widening * coarse.mask.rows()))),
        cols_(2 * cv::getOptimalDFTSize((int(widening * coarse.mask.cols()) + 1) / 2)) {}

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
  double blocks(double fx, double fy) const { return sinc(fx * pitch_) * sinc(fy * pitch_); }

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

// The weights x for which (covariance + noise) x is the map, on the mask.
Grid<double> solved(const Plane& plane, const Grid<double>& covariance, double noise,
                    const CoarseMap& coarse) {
  Grid<double> x(coarse.mask.rows(), coarse.mask.cols());
  Grid<double> rest = coarse.height, direction = rest;
  double square = dot(rest, rest);
  const double aim = enough * enough * square;
  for (int round = 0; round < most_rounds && square > aim; ++round) {
    auto image = plane.map_of(plane.transform(direction), covariance, coarse.mask);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] += noise * direction[i];
    const double step = square / dot(direction, image);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += step * direction[i];
      rest[i] -= step * image[i];
    }
    const double left = dot(rest, rest);
    for (std::size_t i = 0; i < x.size(); ++i)
      direction[i] = rest[i] + left / square * direction[i];
    square = left;
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

// Takes the waves with that transform from the map that they are a part of.
void take_off(const Plane& plane, const Grid<std::complex<double>>& waves, const CoarseMap& coarse,
              Grid<float>& map) {
  // Steps so fine that a cubic between them is exact to 1e-4; whole ones, as far as they go.
  constexpr int finer = 4;
  const auto steps = plane.map_of(waves, coarse.mask, std::min(finer, coarse.block));
  const cv::Mat known(steps.rows(), steps.cols(), CV_64F, const_cast<double*>(steps.data()));
  cv::Mat fine;
  cv::resize(known, fine, {coarse.mask.cols() * coarse.block, coarse.mask.rows() * coarse.block},
             0.0, 0.0, cv::INTER_CUBIC);
  for (int row = 0; row < coarse.box.rows; ++row) {
    for (int col = 0; col < coarse.box.cols; ++col)
      map(coarse.box.row + row, coarse.box.col + col) -= float(fine.at<double>(row, col));
  }
}

// The spectrum that means over blocks have, and the mean a wide one.
Grid<double> covariance_of(const HumpMixture& mixture, const Plane& plane, double variance) {
  auto covariance = plane.filled([&](double fx, double fy) {
    // A power law has no power at 0; below one wave over the plane it rises no further.
    const double f = std::max(std::hypot(fx, fy), 1.0 / plane.longest());
    double density = mixture.ground(f);
    for (const SpectralHump& hump : mixture.humps) density += hump.density(fx, fy);
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
    const SpectralHump& hump = mixture.humps[k];
    if (!is_long(hump)) continue;
    const auto prior = plane.filled([&](double fx, double fy) { return hump.density(fx, fy); });
    auto told = plane.filled([&](double fx, double fy) {
      return hump.density(fx, fy) * std::pow(plane.blocks(fx, fy), 2) / plane.area();
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
