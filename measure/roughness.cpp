#include "measure/roughness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "measure/blocks.h"
#include "measure/hills.h"
#include "measure/jackknife.h"
#include "measure/texture_lengths.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 64;
constexpr double hill_share = 0.05;  // of Sz (ISO 25178-3)

/// Sums over the pixels of a part: what all moments and slopes are made of.
struct Sums {
  double count = 0.0, absolute = 0.0, z = 0.0, z2 = 0.0, z3 = 0.0, z4 = 0.0;
  double squares = 0.0;  // of four neighbouring pixels
  double slope2 = 0.0, area = 0.0, lay_cos = 0.0, lay_sin = 0.0;
  double highest = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();

  void add(const Sums& other, double sign) {
    for (const auto member :
         {&Sums::count, &Sums::absolute, &Sums::z, &Sums::z2, &Sums::z3, &Sums::z4, &Sums::squares,
          &Sums::slope2, &Sums::area, &Sums::lay_cos, &Sums::lay_sin}) {
      this->*member += sign * other.*member;
    }
    highest = std::max(highest, other.highest);
    lowest = std::min(lowest, other.lowest);
  }
};

void add_height(Sums& sums, double z) {
  sums.count += 1.0;
  sums.absolute += std::abs(z);
  sums.z += z;
  sums.z2 += z * z;
  sums.z3 += z * z * z;
  sums.z4 += z * z * z * z;
  sums.highest = std::max(sums.highest, z);
  sums.lowest = std::min(sums.lowest, z);
}

// A square of four pixels: the slopes along its four edges give its two times two triangles, and
// its mean slope the direction of the lay.
void add_square(Sums& sums, const Grid<float>& height, int row, int col, double pitch) {
  const double top = (height(row, col + 1) - height(row, col)) / pitch;
  const double bottom = (height(row + 1, col + 1) - height(row + 1, col)) / pitch;
  const double left = (height(row, col) - height(row + 1, col)) / pitch;  // y runs upward
  const double right = (height(row, col + 1) - height(row + 1, col + 1)) / pitch;
  sums.squares += 1.0;
  sums.slope2 += 0.5 * (top * top + bottom * bottom + left * left + right * right);
  for (const double dx : {top, bottom}) {
    for (const double dy : {left, right}) {
      sums.area += 0.25 * (std::sqrt(1.0 + dx * dx + dy * dy) - 1.0);
    }
  }
  const double dx = 0.5 * (top + bottom);
  const double dy = 0.5 * (left + right);
  sums.lay_cos += dx * dx - dy * dy;
  sums.lay_sin += 2.0 * dx * dy;
}

// Sums that are formed for each row and added up in row order.
std::vector<Sums> sums_of_blocks(const Grid<float>& height, const Mask& mask, double mean,
                                 double pitch) {
  std::vector<Sums> of_rows(std::size_t(height.rows()) * blocks_per_side);
  for_each_index(height.rows(), [&](int row) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      Sums& sums = of_rows[std::size_t(row * blocks_per_side + block_col(height, col))];
      add_height(sums, height(row, col) - mean);
      if (row + 1 < height.rows() && col + 1 < height.cols() && mask(row, col + 1) &&
          mask(row + 1, col) && mask(row + 1, col + 1)) {
        add_square(sums, height, row, col, pitch);
      }
    }
  });
  std::vector<Sums> result(block_count);
  for (int row = 0; row < height.rows(); ++row) {
    for (int k = 0; k < blocks_per_side; ++k) {
      result[std::size_t(block_row(height, row) * blocks_per_side + k)].add(
          of_rows[std::size_t(row * blocks_per_side + k)], 1.0);
    }
  }
  return result;
}

// The numbers that follow from sums. The mean of the sums is no longer quite that which was taken
// off when a block is left out: moments are moved to it, Sa keeps the difference of second order.
Roughness from_sums(const Sums& sums) {
  Roughness found;
  const double n = sums.count, m = sums.z / n;
  const double m2 = sums.z2 / n - m * m;
  found.Sp = sums.highest - m;
  found.Sv = m - sums.lowest;
  found.Sz = sums.highest - sums.lowest;
  found.Sa = sums.absolute / n;
  if (!(m2 > 0.0)) return found;
  found.Sq = std::sqrt(m2);
  const double m3 = sums.z3 / n - 3.0 * m * sums.z2 / n + 2.0 * m * m * m;
  const double m4 =
      sums.z4 / n - 4.0 * m * sums.z3 / n + 6.0 * m * m * sums.z2 / n - 3.0 * m * m * m * m;
  found.Ssk = m3 / std::pow(m2, 1.5);
  found.Sku = m4 / (m2 * m2);
  if (sums.squares == 0.0) return found;
  found.Sdq = std::sqrt(sums.slope2 / sums.squares);
  found.Sdr = sums.area / sums.squares;
  // The lay runs across the steepest direction, the long axis of the covariance of the slopes.
  const double steepest = 0.5 * std::atan2(sums.lay_sin, sums.lay_cos);
  found.Std = std::fmod(steepest + 1.5 * std::numbers::pi, std::numbers::pi);
  return found;
}

double standard_deviation(const std::vector<double>& values) {
  double mean = 0.0, sum = 0.0;
  for (const double value : values) mean += value / double(values.size());
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / (double(values.size()) - 1.0));
}

void set_sigma_of_sums(RoughnessEstimate& found, const Sums& all, const std::vector<Sums>& parts) {
  std::vector<Roughness> without;
  std::vector<double> ratio, peaks, valleys, ranges;
  for (const Sums& part : parts) {
    if (!counts_as_block(part.count, all.count)) continue;
    Sums rest = all;
    rest.add(part, -1.0);
    without.push_back(from_sums(rest));
    ratio.push_back(all.count / part.count);
    peaks.push_back(part.highest);
    valleys.push_back(part.lowest);
    ranges.push_back(part.highest - part.lowest);
  }
  for (const auto member : {&Roughness::Sa, &Roughness::Sq, &Roughness::Ssk, &Roughness::Sku,
                            &Roughness::Sdq, &Roughness::Sdr, &Roughness::Std}) {
    std::vector<LeftOut> left_out;
    for (std::size_t k = 0; k < without.size(); ++k) {
      double value = without[k].*member;
      if (member == &Roughness::Std) {
        value = found.value.Std + std::remainder(value - found.value.Std, std::numbers::pi);
      }
      left_out.push_back({value, ratio[k]});
    }
    found.sigma.*member = jackknife_sigma(found.value.*member, left_out);
  }
  // No direction is less known than one that may be anything.
  found.sigma.Std = std::min(found.sigma.Std, std::numbers::pi / std::sqrt(12.0));
  if (peaks.size() < 2) return;
  found.sigma.Sp = standard_deviation(peaks);
  found.sigma.Sv = standard_deviation(valleys);
  found.sigma.Sz = std::hypot(found.sigma.Sp, found.sigma.Sv);
}

double mean_of(const Grid<float>& height, const Mask& mask) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    sum += height[i];
    count += 1.0;
  }
  if (count < fewest_pixels) {
    throw Error("the mask holds " + std::to_string(int(count)) +
                " pixels, roughness needs at least " + std::to_string(fewest_pixels) +
                ": measure a larger piece");
  }
  return sum / count;
}

RoughnessEstimate estimate(const Grid<float>& height, const Mask& mask, double pitch,
                           bool with_sigma) {
  const auto parts = sums_of_blocks(height, mask, mean_of(height, mask), pitch);
  Sums all;
  for (const Sums& part : parts) all.add(part, 1.0);
  RoughnessEstimate found{from_sums(all), {}};
  // A mirror: no skewness, slope or texture to speak of.
  if (!(found.value.Sz > 0.0) || found.value.Sq == 0.0) return {};
  const TextureLengths texture = texture_lengths(height, mask);
  found.value.Sal = texture.shortest_px * pitch;
  found.value.Str = texture.aspect;
  const double area = all.count * pitch * pitch;
  const int count = hill_count(height, mask, hill_share * found.value.Sz);
  found.value.Spd = count / area;
  found.sigma.Spd = std::sqrt(double(count)) / area;
  if (!with_sigma) return found;
  set_sigma_of_sums(found, all, parts);
  const TextureLengths sigma = texture_lengths_sigma(texture, height, mask);
  found.sigma.Sal = sigma.shortest_px * pitch;
  found.sigma.Str = sigma.aspect;
  return found;
}

}  // namespace

RoughnessEstimate roughness_estimate(const Grid<float>& height, const Mask& mask, double pitch) {
  return estimate(height, mask, pitch, true);
}

Roughness roughness(const Grid<float>& height, const Mask& mask, double pitch) {
  return estimate(height, mask, pitch, false).value;
}

}  // namespace hada
