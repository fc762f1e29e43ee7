#include "fit/dark_discs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace hada {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr float half = 0.5f;
constexpr std::size_t fewest_pixels = 12;  // of a part
constexpr std::size_t most_pixels = 20000;
constexpr std::size_t most_discs = 24;                // of a part
constexpr double least_left = 0.12;                   // of the area of a disc, for one more
constexpr double roundest = 0.3, round_share = 0.04;  // px and of its radius, rms, of one disc
constexpr double least_circumference = 0.15;          // that a disc shows

/// A part: its pixels, and where its border crosses the lines between them.
struct Part {
  Points pixels, border;
};

Part part_from(const Grid<float>& dark, Mask& done, int row, int col) {
  Part part;
  std::vector<std::pair<int, int>> open = {{row, col}};
  done(row, col) = 1;
  while (!open.empty()) {
    const auto [r, c] = open.back();
    open.pop_back();
    part.pixels.push_back({double(r), double(c)});
    for (const auto& [dr, dc] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      if (!dark.contains(r + dr, c + dc)) continue;
      const float here = dark(r, c), there = dark(r + dr, c + dc);
      if (!(there >= half)) {
        if (there != there) continue;  // where the picture ends no border is seen
        const double share = double((here - half) / std::max(here - there, 1e-6f));
        part.border.push_back({r + share * dr, c + share * dc});
      } else if (!done(r + dr, c + dc)) {
        done(r + dr, c + dc) = 1;
        open.push_back({r + dr, c + dc});
      }
    }
  }
  return part;
}

/// The circle nearest to `points`, by Gauss-Newton from `disc`, held near it where they say little.
Disc fitted_circle(const Points& points, Disc disc) {
  constexpr double held = 0.02;  // of a point, how much a start counts
  for (int round = 0; round < 4; ++round) {
    Eigen::Matrix3d normal = held * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector2d& point : points) {
      const Eigen::Vector2d arm = point - disc.place;
      const double distance = std::max(arm.norm(), 1e-6);
      Eigen::Vector3d row;
      row << arm / distance, 1.0;
      normal += row * row.transpose();
      right += row * (distance - disc.radius);
    }
    const Eigen::Vector3d move = normal.ldlt().solve(right);
    disc.place += move.head<2>();
    disc.radius = std::max(disc.radius + move[2], 0.5);
  }
  return disc;
}

/// The points of the border that are nearest to each disc's circle, and not far from it.
std::vector<Points> assigned(const Points& border, const std::vector<Disc>& discs) {
  std::vector<Points> own(discs.size());
  for (const Eigen::Vector2d& point : border) {
    std::size_t best = 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < discs.size(); ++k) {
      const double off = std::abs((point - discs[k].place).norm() - discs[k].radius);
      if (off >= least) continue;
      least = off;
      best = k;
    }
    if (least < 1.0 + 0.3 * discs[best].radius) own[best].push_back(point);
  }
  return own;
}

void add_discs(const Part& part, std::vector<Disc>& all) {
  Points left = part.pixels;
  std::vector<Disc> discs;
  while (discs.size() < most_discs) {
    Disc largest{{0.0, 0.0}, 0.0};
    for (const Eigen::Vector2d& pixel : left) {
      double room = HUGE_VAL;
      for (const Eigen::Vector2d& point : part.border) {
        room = std::min(room, (point - pixel).squaredNorm());
        if (room <= largest.radius * largest.radius) break;
      }
      room = std::sqrt(room);
      if (room < HUGE_VAL && room > largest.radius) largest = {pixel, room};
    }
    if (largest.radius <= 0.0) break;
    discs.push_back(largest);
    for (int round = 0; round < 3; ++round) {
      const auto own = assigned(part.border, discs);
      for (std::size_t k = 0; k < discs.size(); ++k) {
        if (own[k].size() >= 3) discs[k] = fitted_circle(own[k], discs[k]);
      }
    }
    left.clear();
    double usual = 0.0;
    for (const Disc& disc : discs)
      usual += std::numbers::pi * disc.radius * disc.radius / double(discs.size());
    for (const Eigen::Vector2d& pixel : part.pixels) {
      const bool covered = std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
        return (pixel - disc.place).norm() < disc.radius + 0.7;
      });
      if (!covered) left.push_back(pixel);
    }
    if (double(left.size()) < std::max(least_left * usual, 3.0)) break;
  }
  const auto own = assigned(part.border, discs);
  if (discs.size() == 1 && own[0].size() == part.border.size()) {
    double square = 0.0;
    for (const Eigen::Vector2d& point : own[0])
      square += std::pow((point - discs[0].place).norm() - discs[0].radius, 2);
    const double most = roundest + round_share * discs[0].radius;
    discs[0].alone = square < most * most * double(own[0].size());
  }
  for (std::size_t k = 0; k < discs.size(); ++k) {
    // Two lines of the lattice cross a circle 8 r times.
    if (double(own[k].size()) >= least_circumference * 8.0 * discs[k].radius)
      all.push_back(discs[k]);
  }
}

}  // namespace

std::vector<Disc> dark_discs(const Grid<float>& dark) {
  std::vector<Disc> discs;
  Mask done(dark.rows(), dark.cols(), 0);
  for (int row = 0; row < dark.rows(); ++row) {
    for (int col = 0; col < dark.cols(); ++col) {
      if (done(row, col) || !(dark(row, col) >= half)) continue;
      const Part part = part_from(dark, done, row, col);
      if (part.pixels.size() < fewest_pixels || part.pixels.size() > most_pixels) continue;
      add_discs(part, discs);
    }
  }
  return discs;
}

}  // namespace hada
