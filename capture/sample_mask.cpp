#include "capture/sample_mask.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "capture/opencv_view.h"

namespace hada {
namespace {

struct Parting {
  double threshold;  // of the logarithm
  double contrast;   // difference between the means of the two classes, of the logarithm
};

// Otsu's threshold on a histogram of 256 steps.
Parting best_parting(const std::vector<float>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double step = (double(*high) - *low) / 256.0;
  if (!(step > 0.0)) return {*low, 0.0};
  std::array<double, 256> histogram{};
  for (const float value : values) {
    ++histogram[std::size_t(std::clamp(int((value - *low) / step), 0, 255))];
  }
  double total = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < 256; ++i) {
    total += histogram[i];
    moment += histogram[i] * double(i);
  }
  Parting best{*low, 0.0};
  double best_variance = -1.0;
  double below = 0.0;
  double moment_below = 0.0;
  for (std::size_t i = 0; i + 1 < 256; ++i) {
    below += histogram[i];
    moment_below += histogram[i] * double(i);
    if (below == 0.0 || below == total) continue;
    const double gap = (moment - moment_below) / (total - below) - moment_below / below;
    const double variance = below * (total - below) * gap * gap;
    if (variance > best_variance) {
      best_variance = variance;
      best = {*low + step * double(i + 1), gap * step};
    }
  }
  return best;
}

void clear_disc(Mask& mask, const Sphere& sphere, double reach_px) {
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      const Eigen::Vector2d at(col + 0.5, row + 0.5);
      if ((at - sphere.center_px).norm() < reach_px) mask(row, col) = 0;
    }
  }
}

// The largest connected region of a mask, its holes filled.
Mask largest_region(const Mask& mask) {
  cv::Mat labels, statistics, centers;
  const int count = cv::connectedComponentsWithStats(view(mask), labels, statistics, centers, 4);
  int best = 0;
  for (int label = 1; label < count; ++label) {
    const int area = statistics.at<int>(label, cv::CC_STAT_AREA);
    if (best == 0 || area > statistics.at<int>(best, cv::CC_STAT_AREA)) best = label;
  }
  Mask region(mask.rows(), mask.cols(), 0);
  if (best == 0) return region;
  // Whatever the outside does not reach belongs to the region. A frame of one pixel joins the
  // outside into one.
  cv::Mat outside;
  cv::copyMakeBorder(cv::Mat(labels != best), outside, 1, 1, 1, 1, cv::BORDER_CONSTANT, 255);
  cv::Mat flooded;
  cv::connectedComponents(outside, flooded, 4);
  const int open = flooded.at<int>(0, 0);
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      region(row, col) = flooded.at<int>(row + 1, col + 1) != open;
    }
  }
  return region;
}

}  // namespace

Mask sample_mask(const Grid<float>& brightness, const std::vector<Sphere>& spheres,
                 const std::optional<BoxPx>& box) {
  const int rows = brightness.rows();
  const int cols = brightness.cols();
  Mask candidates(rows, cols, 1);
  if (box) {
    const double margin = 0.02 * std::max((*box)[2] - (*box)[0], (*box)[3] - (*box)[1]);
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        candidates(row, col) = col + 0.5 > (*box)[0] - margin && col + 0.5 < (*box)[2] + margin &&
                               row + 0.5 > (*box)[1] - margin && row + 0.5 < (*box)[3] + margin;
      }
    }
  }
  for (const Sphere& sphere : spheres) clear_disc(candidates, sphere, 1.03 * sphere.radius_px + 2);

  cv::Mat smooth;
  cv::medianBlur(view(brightness), smooth, 3);
  // The highlight of a chrome sphere in a float picture can be a thousand times as bright as paper.
  float brightest = 0.0f;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (candidates(row, col)) brightest = std::max(brightest, smooth.at<float>(row, col));
    }
  }
  const float least = 1e-3f * brightest + 1e-12f;  // what is darker is black
  std::vector<float> logs;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (candidates(row, col)) {
        logs.push_back(std::log(std::max(smooth.at<float>(row, col), least)));
      }
    }
  }
  if (logs.empty()) return {};
  const Parting parting = best_parting(logs);
  const bool has_table = parting.contrast > std::log(3.0);
  Mask bright = candidates;
  if (has_table) {
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        const float value = std::log(std::max(smooth.at<float>(row, col), least));
        bright(row, col) = candidates(row, col) && value > parting.threshold;
      }
    }
    cv::Mat opened;
    cv::morphologyEx(view(bright), opened, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
    opened.copyTo(view(bright));
  }
  Mask region = largest_region(bright);
  for (const Sphere& sphere : spheres) clear_disc(region, sphere, 1.03 * sphere.radius_px + 2);
  if (has_table) {
    cv::Mat shrunk;
    cv::erode(view(region), shrunk, cv::Mat::ones(3, 3, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT,
              cv::Scalar(1));
    shrunk.copyTo(view(region));
  }
  const auto area = std::count(region.begin(), region.end(), 1);
  return double(area) < 0.01 * rows * cols ? Mask{} : region;
}

}  // namespace hada
