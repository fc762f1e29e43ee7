#include "measure/background.h"

#include <cmath>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr float same_brightness = 0.04f;  // share by which a plain background may differ
constexpr double least_plain = 0.75;      // share of the border

std::vector<std::pair<int, int>> border_of(const Mask& mask) {
  std::vector<std::pair<int, int>> border;
  for (int col = 0; col < mask.cols(); ++col) {
    border.emplace_back(0, col);
    border.emplace_back(mask.rows() - 1, col);
  }
  for (int row = 1; row + 1 < mask.rows(); ++row) {
    border.emplace_back(row, 0);
    border.emplace_back(row, mask.cols() - 1);
  }
  return border;
}

}  // namespace

Mask without_background(const Grid<float>& brightness, const Mask& mask, int margin_px) {
  auto open = border_of(mask);
  std::vector<float> values;
  for (const auto& [row, col] : open) values.push_back(brightness(row, col));
  const float usual = median(values);
  const auto plain = [&](int row, int col) {
    return std::abs(brightness(row, col) - usual) <= same_brightness * std::abs(usual);
  };
  std::size_t count = 0;
  for (const auto& [row, col] : open) count += plain(row, col) ? 1 : 0;
  if (double(count) < least_plain * double(open.size())) return mask;

  Mask outside(mask.rows(), mask.cols(), 0);
  while (!open.empty()) {
    const auto [row, col] = open.back();
    open.pop_back();
    if (!mask.contains(row, col) || outside(row, col) || !plain(row, col)) continue;
    outside(row, col) = 255;
    for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}})
      open.emplace_back(row + down, col + right);
  }
  const cv::Mat1b before(mask.rows(), mask.cols(), outside.data());
  cv::Mat1b grown;
  const int side = 2 * margin_px + 1;
  cv::dilate(before, grown, cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side}));
  Mask inside = mask;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (grown(row, col)) inside(row, col) = 0;
    }
  }
  return inside;
}

}  // namespace hada
