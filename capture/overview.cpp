#include "capture/overview.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/quantile.h"
#include "io/image_file.h"

namespace hada {
namespace {

float quantile_of(const Grid<float>& picture, double share) {
  return quantile(std::vector<float>(picture.begin(), picture.end()), share);
}

}  // namespace

Overview overview(const Photographs& photographs, bool linear) {
  Overview all;
  for (const Image& image : photographs.images) {
    Grid<float> grey = luminance(image);
    if (!linear) {
      for (float& value : grey) value = linear_from_srgb(value);
    }
    all.bright.push_back(quantile_of(grey, 0.99));
    all.glint.push_back(quantile_of(grey, 1.0));
    grey.let_go();
    all.greys.push_back(std::move(grey));
  }
  const int rows = all.greys[0].rows();
  const int cols = all.greys[0].cols();
  // Below this the logarithm would only magnify noise and code values.
  const float least =
      std::max(0.002f * all.bright[0], photographs.bits <= 8 ? 1.0f / 255.0f : 1e-5f);
  all.mean_log = all.brightest = all.brightest_log = Grid<float>(rows, cols);
  const auto look_at_row = [&](int row) {
    for (int col = 0; col < cols; ++col) {
      double sum = 0.0;
      float highest = 0.0f;
      for (const auto& grey : all.greys) {
        const float value = std::max(grey(row, col), 0.0f);
        sum += std::log(value + least);
        highest = std::max(highest, value);
      }
      all.mean_log(row, col) = float(sum / double(all.greys.size()));
      all.brightest(row, col) = highest;
      all.brightest_log(row, col) = std::log(highest + least);
    }
  };
  for_slices(rows, [&](int first, int last) {
    for_each_band(first, last, [&](int begin, int end) {
      for (int row = begin; row < end; ++row) look_at_row(row);
      for (const auto& grey : all.greys) grey.let_go(begin, end);
    });
  });
  return all;
}

}  // namespace hada
