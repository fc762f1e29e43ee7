#include "fit/dark_wood.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr double least_radius_px = 4.0;
constexpr double least_depth = 0.15;    // of a vessel, beside the brightness of the wood
constexpr double least_contrast = 4.0;  // depth over the scatter of the wood
constexpr double beyond_wood = 3.0;     // scatters: what is darker is hardly wood
constexpr double least_share = 0.002;   // of the pixels, in vessels
constexpr double least_piece_px = 2.5;  // radius of what is more than a remnant of taking apart
constexpr std::size_t fewest = 10;
constexpr double rings_per_px = 2.0;  // that wood is compared in: boundaries are sharp
constexpr double sector_px = 150.0;   // along a ring: wood that shares one brightness
constexpr int coarse = 4;             // px, from one to the next, for a first look

/// A pixel of the wood and the cell whose wood it belongs to.
struct Place {
  int row, col;
  std::size_t cell;
};

class Ground {
 public:
  Ground(const Grid<float>& brightness, const Mask& wood, const GrowthFrame& frame,
         const Extent& extent, int step)
      : dark_(extent.rows, extent.cols, std::nanf("")) {
    std::map<std::pair<int, int>, std::size_t> cells;
    for (int row = step / 2; row < extent.rows; row += step) {
      for (int col = step / 2; col < extent.cols; col += step) {
        if (!wood(row, col)) continue;
        const Eigen::Vector2d place = extent.place(row, col);
        const double rho = frame.rho_of(place) / extent.pitch;
        const Eigen::Vector2d arm = place - frame.pith;
        const int ring = int(rings_per_px * rho / step);
        const int sectors =
            std::clamp(int(2.0 * std::numbers::pi * rho / (sector_px * step)), 1, 1024);
        const int sector =
            int((std::atan2(arm.y(), arm.x()) / (2.0 * std::numbers::pi) + 0.5) * sectors);
        const auto [at, added] = cells.try_emplace({ring, sector}, cells.size());
        places_.push_back({row, col, at->second});
      }
    }
    ground_.resize(cells.size());
    set_ground(brightness, 0.7, HUGE_VAL);
    for (int round = 0; round < 2; ++round) {
      set_depth();
      set_ground(brightness, 0.5, 0.5 * depth_);
    }
    set_depth();
  }

  double depth() const { return depth_; }
  double scatter() const { return scatter_; }

  /// 0 where there is wood, 1 in vessels, NaN where there is neither.
  Grid<float> dark() const {
    Grid<float> result = dark_;
    for (float& value : result) value /= float(depth_);
    return result;
  }

 private:
  /// A quantile of what is in each cell, of that no darker than `darkest`.
  void set_ground(const Grid<float>& brightness, double share, double darkest) {
    std::vector<std::vector<float>> seen(ground_.size());
    for (const Place& place : places_) {
      if (double(dark_(place.row, place.col)) > darkest) continue;
      seen[place.cell].push_back(brightness(place.row, place.col));
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!seen[k].empty()) ground_[k] = quantile(std::move(seen[k]), share);
    }
    for (const Place& place : places_)
      dark_(place.row, place.col) =
          1.0f - brightness(place.row, place.col) / std::max(ground_[place.cell], 1e-3f);
  }

  /// What vessels take away, and how wood scatters: as on its light side, where no vessel is.
  void set_depth() {
    std::vector<float> values;
    values.reserve(places_.size());
    for (const Place& place : places_) values.push_back(dark_(place.row, place.col));
    depth_ = scatter_ = 0.0;
    if (values.empty()) return;
    scatter_ = double(median(values) - quantile(values, 0.16));
    double threshold = beyond_wood * scatter_;
    for (int round = 0; round < 3; ++round) {
      std::vector<float> vessels;
      std::copy_if(values.begin(), values.end(), std::back_inserter(vessels),
                   [&](float value) { return double(value) > threshold; });
      if (double(vessels.size()) < least_share * double(values.size())) {
        depth_ = 0.0;
        return;
      }
      depth_ = double(median(std::move(vessels)));
      threshold = std::max(threshold, 0.5 * depth_);
    }
  }

  std::vector<Place> places_;
  std::vector<float> ground_;
  Grid<float> dark_;
  double depth_ = 0.0, scatter_ = 0.0;
};

bool shows_vessels(const Ground& ground) {
  return ground.depth() > least_depth && ground.depth() > least_contrast * ground.scatter();
}

}  // namespace

std::optional<DarkWood> dark_wood(const Grid<float>& brightness, const Mask& wood,
                                  const GrowthFrame& frame, const Extent& extent) {
  if (!shows_vessels(Ground(brightness, wood, frame, extent, coarse))) return std::nullopt;
  const Ground ground(brightness, wood, frame, extent, 1);
  if (!shows_vessels(ground)) return std::nullopt;
  DarkWood seen{ground.dark(), ground.depth(), ground.scatter(), {}};
  seen.discs = dark_discs(seen.dark);
  std::erase_if(seen.discs, [](const Disc& disc) { return disc.radius < least_piece_px; });
  std::vector<double> radii;
  for (const Disc& disc : seen.discs) radii.push_back(disc.radius);
  if (radii.size() < fewest || median(std::move(radii)) < least_radius_px) return std::nullopt;
  return seen;
}

}  // namespace hada
