#include "app/draw/cut_picture.h"

#include <algorithm>
#include <cmath>

#include "app/draw/palette.h"

namespace hada {
namespace {

constexpr double ninety = 1.6449;  // deviations on each side that hold 90 % of a Gaussian
constexpr Colour line{0.85f, 0.10f, 0.05f}, band{0.10f, 0.45f, 0.90f};
constexpr float line_share = 0.9f, band_share = 0.35f;
constexpr double widest_px = 40.0;  // of a band that is still drawn

/// How much of a colour each pixel gets: the most that any station asks for, two px along its line.
void cover(Grid<float>& shares, const Extent& extent, const RingStation& station, double by,
           float share) {
  const Eigen::Vector2d along(-station.normal.y(), station.normal.x());
  for (const double way : {-0.7, 0.0, 0.7}) {
    const Eigen::Vector2d pixel =
        extent.pixel(station.place + extent.pitch * (by * station.normal + way * along));
    const int row = int(std::lround(pixel.x())), col = int(std::lround(pixel.y()));
    if (shares.contains(row, col)) shares(row, col) = std::max(shares(row, col), share);
  }
}

void mix(Image& picture, const Grid<float>& shares, const Colour& colour) {
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < shares.size(); ++i)
      picture.planes[c][i] += shares[i] * (colour[c] - picture.planes[c][i]);
  }
}

}  // namespace

Image cut_picture(Image picture, const CutPrediction& cut) {
  while (picture.channels() < 3) picture.planes.push_back(picture.planes.front());
  const Extent& extent = cut.extent;
  Grid<float> bands(extent.rows, extent.cols, 0.0f), lines = bands;
  for (const RingStation& station : cut.rings) {
    const double half = std::min(ninety * station.sigma / extent.pitch, widest_px);
    for (double by = -half; by <= half; by += 0.5) cover(bands, extent, station, by, band_share);
    cover(lines, extent, station, 0.0, line_share);
  }
  mix(picture, bands, band);
  mix(picture, lines, line);
  return picture;
}

Image beside(const Image& left, const Image& right) {
  constexpr int gap_px = 8;
  Image both(std::max(left.rows(), right.rows()), left.cols() + gap_px + right.cols(), 3);
  for (auto& plane : both.planes) std::fill(plane.begin(), plane.end(), 1.0f);
  const auto put = [&](const Image& picture, int at) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& from = picture.planes[std::min(c, picture.planes.size() - 1)];
      for (int row = 0; row < picture.rows(); ++row)
        std::copy(from.row(row).begin(), from.row(row).end(), both.planes[c].row(row).begin() + at);
    }
  };
  put(left, 0);
  put(right, left.cols() + gap_px);
  return both;
}

}  // namespace hada
