#include "measure/histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measure/blocks.h"
#include "measure/jackknife.h"

namespace hada {

Histogram histogram(const Grid<float>& values, const Mask& mask, double low, double high,
                    int bins) {
  const std::size_t n = std::size_t(std::max(bins, 1));
  const double width = high > low ? high - low : 1.0;  // a flat map has no spread to go by
  Histogram result{low, width / double(n), std::vector<double>(n, 0.0),
                   std::vector<double>(n, 0.0)};
  std::array<double, block_count> pixels{};
  std::array<std::vector<double>, block_count> counts;
  counts.fill(std::vector<double>(n, 0.0));
  for (int row = 0; row < values.rows(); ++row) {
    for (int col = 0; col < values.cols(); ++col) {
      if (!mask(row, col)) continue;
      const auto block = std::size_t(block_at(values, row, col));
      pixels[block] += 1.0;
      const double bin = std::floor((double(values(row, col)) - low) / result.step);
      if (bin >= 0.0 && bin < double(n)) counts[block][std::size_t(bin)] += 1.0;
    }
  }
  double all = 0.0;
  for (const double count : pixels) all += count;
  for (std::size_t bin = 0; bin < n; ++bin) {
    double sum = 0.0;
    for (const auto& of_block : counts) sum += of_block[bin];
    std::vector<LeftOut> left_out;
    for (std::size_t block = 0; block < pixels.size(); ++block) {
      if (!counts_as_block(pixels[block], all)) continue;
      left_out.push_back(
          {(sum - counts[block][bin]) / (all - pixels[block]) / result.step, all / pixels[block]});
    }
    result.density[bin] = all > 0.0 ? sum / all / result.step : 0.0;
    result.sigma[bin] = jackknife_sigma(result.density[bin], left_out);
  }
  return result;
}

Grid<float> steepness(const Grid<float>& height, const Mask& mask, double pitch) {
  const NormalMap normals = normals_of(height, mask, pitch);
  Grid<float> steep(height.rows(), height.cols());
  for (std::size_t i = 0; i < steep.size(); ++i)
    steep[i] = std::hypot(normals[i].x(), normals[i].y()) / normals[i].z();
  return steep;
}

}  // namespace hada
