#include "capture/edge_gradient.h"

#include <algorithm>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "capture/opencv_view.h"
#include "core/quantile.h"

namespace hada {

Gradient gradient_of(const Grid<float>& grey) {
  std::vector<float> values(grey.begin(), grey.end());
  const float bright = quantile(std::move(values), 0.95) + 1e-9f;
  Grid<float> shares(grey.rows(), grey.cols());
  std::transform(grey.begin(), grey.end(), shares.begin(),
                 [&](float value) { return std::clamp(value / bright, 0.0f, 1.0f); });
  cv::GaussianBlur(view(shares), view(shares), {}, 1.0, 1.0, cv::BORDER_REPLICATE);
  Gradient gradient{Grid<float>(grey.rows(), grey.cols()), Grid<float>(grey.rows(), grey.cols())};
  for (int row = 1; row + 1 < grey.rows(); ++row) {
    for (int col = 1; col + 1 < grey.cols(); ++col) {
      gradient.u(row, col) = 0.5f * (shares(row, col + 1) - shares(row, col - 1));
      gradient.v(row, col) = 0.5f * (shares(row + 1, col) - shares(row - 1, col));
    }
  }
  return gradient;
}

}  // namespace hada
